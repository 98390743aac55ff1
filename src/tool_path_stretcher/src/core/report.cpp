// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scan_cell_common/files/files.h"

namespace tool_path_stretcher {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN: null means unknown.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

template <class Matrix>
Json rows(const Matrix& matrix) {
  Json result = Json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < matrix.cols(); ++c)
      row.push_back(number(matrix(r, c)));
    result.push_back(row);
  }
  return result;
}

Json list(const Eigen::Vector3d& vector) {
  return {number(vector.x()), number(vector.y()), number(vector.z())};
}

Json to_json(const PoseCandidate& candidate) {
  Json waypoints = Json::array();
  for (const Eigen::Vector3d& at : candidate.waypoints)
    waypoints.push_back(list(at));
  return {{"scale", number(candidate.similarity.scale)},
          {"translation", list(candidate.similarity.translation)},
          {"rotation", rows(candidate.similarity.rotation)},
          {"transform", rows(candidate.similarity.matrix())},
          {"waypoints", waypoints}};
}

Json to_json(const WaypointQuality& quality) {
  return {{"segment", quality.segment},
          {"waypoint", quality.waypoint},
          {"measured", quality.measured},
          {"in_air", quality.in_air},
          {"distance_to_scan", number(quality.distance_to_scan)},
          {"support", quality.support},
          {"residual", number(quality.residual)},
          {"displacement", number(quality.displacement)},
          {"surface_angle", number(quality.surface_angle)},
          {"gap", number(quality.gap)},
          {"strangers", quality.strangers},
          {"expected_error_normal", number(quality.expected_error_normal)},
          {"expected_error_tangential", number(quality.expected_error_tangential)},
          {"expected_error_across", number(quality.expected_error_across)},
          {"expected_error_orientation", number(quality.expected_error_orientation)},
          {"least_known", list(quality.least_known)},
          {"position_measured", quality.position_measured}};
}

Json to_json(const tool_paths::PathContents& contents) {
  return {{"waypoints", contents.waypoints},           {"segments", contents.segments},
          {"orientations", contents.orientations},     {"units", contents.units},
          {"process_values", contents.process_values}, {"kept", contents.kept}};
}

Json to_json(const std::optional<FileRecord>& file) {
  if (!file) return nullptr;
  return {{"name", file->name}, {"sha256", file->sha256}, {"units", file->units}};
}

/// Adds what to look at first.
void add_head(const StretchResult& result, Json& report) {
  const QualitySummary summary = summary_of(result.quality);
  const bool known = !result.quality.empty();
  report["verdict"] = result.verdict.accepted() ? "accepted" : "refused";
  report["reason"] = to_string(result.verdict.reason);
  report["message"] = result.verdict.message;
  report["measured_waypoints"] = known ? Json(summary.measured) : Json(nullptr);
  report["inferred_waypoints"] = known ? Json(summary.inferred) : Json(nullptr);
  report["waypoints_in_air"] = known ? Json(summary.in_air) : Json(nullptr);
  report["largest_displacement"] = number(summary.largest_displacement);
  report["largest_expected_error_normal"] = number(summary.largest_expected_error_normal);
  report["largest_expected_error_tangential"] = number(summary.largest_expected_error_tangential);
  report["largest_expected_error_orientation"] = number(summary.largest_expected_error_orientation);
}

void add_record(const StretchResult& result, const RunRecord& record, Json& report) {
  report["path"] = record.path ? to_json(*record.path) : Json(nullptr);
  report["files"] = {{"reference", to_json(record.reference)},
                     {"object", to_json(record.object)},
                     {"path", to_json(record.path_file)},
                     {"output", to_json(record.output)}};
  report["seconds"] = number(total_seconds(result, record));
  report["seconds_of"] = {{"reading", number(record.seconds_reading)},
                          {"adapting", number(result.seconds)},
                          {"writing", number(record.seconds_writing)}};
}

/// @param known false: the run did not get that far
template <class Value>
Json if_known(bool known, const Value& value) {
  return known ? Json(value) : Json(nullptr);
}

void add_alignment(const StretchResult& result, Json& report) {
  const bool known = result.aligned;
  report["scale"] = if_known(known, number(result.similarity.scale));
  report["translation"] = if_known(known, list(result.similarity.translation));
  report["rotation"] = if_known(known, rows(result.similarity.rotation));
  report["transform"] = if_known(known, rows(result.similarity.matrix()));
  report["deformation_nodes"] = if_known(known, result.deformation_nodes);
  report["rms"] = if_known(known, number(result.rms));
  report["inlier_ratio"] = if_known(known, number(result.inlier_ratio));
  report["overlap"] = if_known(known, number(result.overlap));
  report["reference_points"] = if_known(result.reference_points > 0, result.reference_points);
  report["object_points"] = if_known(result.object_points > 0, result.object_points);
}

}  // namespace

std::string report_to_json(const StretchResult& result, const RunRecord& record) {
  Json report;
  add_head(result, report);
  report["waypoints_concerned"] = result.verdict.waypoints;
  report["candidates"] = Json::array();
  for (const PoseCandidate& candidate : result.verdict.candidates)
    report["candidates"].push_back(to_json(candidate));
  report["method"] = to_string(result.method);
  add_alignment(result, report);
  add_record(result, record, report);
  report["quality"] = Json::array();
  for (const WaypointQuality& quality : result.quality)
    report["quality"].push_back(to_json(quality));
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save_report(const std::string& path, const StretchResult& result, const RunRecord& record) {
  scan_cell_common::save_text(path, report_to_json(result, record));
}

}  // namespace tool_path_stretcher
