// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/reported_verdict.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_stretcher/waypoint_quality.h"

namespace tool_path_stretcher {
namespace {

using nlohmann::json;

/// From a 4 x 4 matrix, reference to object.
Similarity similarity_of(const json& rows) {
  Eigen::Matrix4d matrix;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c)
      matrix(r, c) =
          rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
  }
  const Eigen::Matrix3d scaled = matrix.topLeftCorner<3, 3>();
  const double scale = std::cbrt(scaled.determinant());
  if (!(scale > 0))
    throw scan_cell_common::UnusableInput("transform", "mirrored, or of scale 0", "");
  return {scale, scaled / scale, matrix.topRightCorner<3, 1>()};
}

std::optional<FileRecord> file_of(const json& file) {
  if (file.is_null()) return {};
  return FileRecord{file.at("name").get<std::string>(), file.at("sha256").get<std::string>(),
                    file.at("units").get<std::string>()};
}

std::size_t count_of(const json& count) {
  return count.is_null() ? 0 : count.get<std::size_t>();
}

/// NaN if unknown.
double figure_of(const json& quality, const char* name) {
  const auto figure = quality.find(name);
  return figure == quality.end() || figure->is_null() ? kUnknown : figure->get<double>();
}

ReportedVerdict verdict_of(const json& report) {
  ReportedVerdict verdict;
  verdict.accepted = report.at("verdict").get<std::string>() == "accepted";
  verdict.reason = report.at("reason").get<std::string>();
  verdict.message = report.at("message").get<std::string>();
  verdict.waypoints = report.at("waypoints_concerned").get<std::vector<std::size_t>>();
  const bool aligned = !report.at("transform").is_null();
  const json& candidates = report.at("candidates");
  const bool undecided = !verdict.accepted && !candidates.empty();
  for (std::size_t i = 0; undecided && i < candidates.size(); ++i)
    verdict.similarities.push_back(similarity_of(candidates[i].at("transform")));
  if (aligned && !undecided) verdict.similarities.push_back(similarity_of(report.at("transform")));
  const json& files = report.at("files");
  verdict.reference = file_of(files.at("reference"));
  verdict.object = file_of(files.at("object"));
  verdict.path = file_of(files.at("path"));
  verdict.output = file_of(files.at("output"));
  verdict.reference_points = count_of(report.at("reference_points"));
  verdict.object_points = count_of(report.at("object_points"));
  const json& given = report.at("path");
  if (!given.is_null()) verdict.waypoints_given = given.at("waypoints").get<std::size_t>();
  for (const json& quality : report.at("quality")) {
    if (quality.value("in_air", false)) verdict.in_air.push_back(verdict.displacements.size());
    verdict.displacements.push_back(quality.at("displacement").get<double>());
    verdict.expected_errors.push_back(std::hypot(figure_of(quality, "expected_error_normal"),
                                                 figure_of(quality, "expected_error_tangential")));
  }
  return verdict;
}

}  // namespace

ReportedVerdict load_report(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw scan_cell_common::FileError(path, "cannot be read", "give a report of stretch");
  try {
    return verdict_of(json::parse(file));
  } catch (const json::exception& error) {
    throw scan_cell_common::UnusableInput(path, error.what(), "give a report of stretch");
  }
}

}  // namespace tool_path_stretcher
