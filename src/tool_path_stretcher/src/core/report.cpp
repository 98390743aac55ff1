// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scan_cell_common/yaml_file.h"

namespace tool_path_stretcher {
namespace {

using Json = nlohmann::ordered_json;

/// JSON knows no NaN: null is what is not known.
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
          {"least_known", list(quality.least_known)},
          {"position_measured", quality.position_measured}};
}

}  // namespace

std::string report_to_json(const StretchResult& result) {
  Json report;
  report["verdict"] = result.verdict.accepted() ? "accepted" : "refused";
  report["reason"] = to_string(result.verdict.reason);
  report["message"] = result.verdict.message;
  report["waypoints_concerned"] = result.verdict.waypoints;
  report["candidates"] = Json::array();
  for (const PoseCandidate& candidate : result.verdict.candidates)
    report["candidates"].push_back(to_json(candidate));
  report["method"] = to_string(result.method);
  report["scale"] = number(result.similarity.scale);
  report["translation"] = list(result.similarity.translation);
  report["rotation"] = rows(result.similarity.rotation);
  report["transform"] = rows(result.similarity.matrix());
  report["deformation_nodes"] = result.deformation_nodes;
  report["rms"] = number(result.rms);
  report["inlier_ratio"] = number(result.inlier_ratio);
  report["overlap"] = number(result.overlap);
  report["seconds"] = number(result.seconds);
  report["reference_points"] = result.reference_points;
  report["object_points"] = result.object_points;
  report["quality"] = Json::array();
  for (const WaypointQuality& quality : result.quality)
    report["quality"].push_back(to_json(quality));
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void save_report(const std::string& path, const StretchResult& result) {
  scan_cell_common::save_text(path, report_to_json(result));
}

}  // namespace tool_path_stretcher
