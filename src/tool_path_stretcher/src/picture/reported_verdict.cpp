// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors.h"
#include "verdict_picture.h"

namespace tool_path_stretcher {
namespace {

using Json = nlohmann::json;

/// From a 4 x 4 matrix, reference to object.
Similarity similarity_of(const Json& rows) {
  Eigen::Matrix4d matrix;
  for (int r = 0; r < 4; ++r) {
    for (int c = 0; c < 4; ++c)
      matrix(r, c) =
          rows.at(static_cast<std::size_t>(r)).at(static_cast<std::size_t>(c)).get<double>();
  }
  const Eigen::Matrix3d scaled = matrix.topLeftCorner<3, 3>();
  const double scale = std::cbrt(scaled.determinant());
  if (!(scale > 0)) throw scan_cell_common::UnusableInput("transform", "turns inside out", "");
  return {scale, scaled / scale, matrix.topRightCorner<3, 1>()};
}

ReportedVerdict verdict_of(const Json& report) {
  ReportedVerdict verdict;
  verdict.accepted = report.at("verdict").get<std::string>() == "accepted";
  verdict.reason = report.at("reason").get<std::string>();
  verdict.message = report.at("message").get<std::string>();
  verdict.waypoints = report.at("waypoints_concerned").get<std::vector<std::size_t>>();
  const bool aligned = report.at("inlier_ratio").get<double>() > 0;
  const Json& candidates = report.at("candidates");
  for (const Json& candidate : candidates)
    verdict.similarities.push_back(similarity_of(candidate.at("transform")));
  if (aligned && candidates.empty())
    verdict.similarities.push_back(similarity_of(report.at("transform")));
  return verdict;
}

}  // namespace

ReportedVerdict load_report(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw scan_cell_common::FileError(path, "cannot be read", "give a report of stretch");
  try {
    return verdict_of(Json::parse(file));
  } catch (const Json::exception& error) {
    throw scan_cell_common::UnusableInput(path, error.what(), "give a report of stretch");
  }
}

}  // namespace tool_path_stretcher
