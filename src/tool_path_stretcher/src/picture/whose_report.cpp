// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/kd_tree.h"
#include "scan_cell_common/errors/errors.h"
#include "verdict_picture.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

constexpr const char* kCure = "give the files of the run that wrote the report";

void check_same(const std::string& file, const std::optional<FileRecord>& reported,
                const std::string& role) {
  if (!reported || record_of(file, reported->units).sha256 == reported->sha256) return;
  throw UnusableInput(
      file, fmt::format("not the {} of the report, which was {}", role, reported->name), kCure);
}

void check_points(const Surface& surface, std::size_t reported, const std::string& role) {
  if (reported == 0 || surface.points.size() == reported) return;
  throw UnusableInput(role,
                      fmt::format("{} points after the grid reduction, {} in the report",
                                  surface.points.size(), reported),
                      std::string(kCure) + ", and its --leaf and --units");
}

void check_waypoints(const ToolPath& path, std::size_t reported, const std::string& role) {
  const std::size_t count = waypoint_count(path);
  if (count == reported) return;
  throw UnusableInput(role, fmt::format("{} waypoints, {} in the report", count, reported), kCure);
}

/// The report tells how far each waypoint is from where the similarity puts it. A kept stand-off
/// may add to this, by no more than the waypoint's distance from the reference.
void check_displacements(const PictureInput& input) {
  constexpr double kRounding = 1e-6;  // [m]
  const Points from = positions_of(input.path);
  const Points to = positions_of(*input.adapted);
  const std::vector<double>& reported = input.verdict.displacements;
  check_waypoints(*input.adapted, reported.size(), "adapted path");
  if (from.size() != to.size() || input.verdict.similarities.empty()) return;  // resampled
  const Similarity& similarity = input.verdict.similarities[0];
  double highest = 0;
  for (const Eigen::Vector3d& at : from)
    highest = std::max(highest, std::sqrt(input.reference.tree->nearest(at).squared_distance));
  const double stand_off = std::abs(1 - similarity.scale) * highest;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const double moved = (to[i] - similarity * from[i]).norm();
    if (std::abs(moved - reported[i]) <= stand_off + kRounding) continue;
    throw UnusableInput(
        "adapted path",
        fmt::format("waypoint {} lies {:.4g} mm from where the similarity puts it, {:.4g} "
                    "mm in the report",
                    i, 1e3 * moved, 1e3 * reported[i]),
        kCure);
  }
}

}  // namespace

void check_same_files(const ReportedVerdict& verdict, const PictureFiles& files) {
  check_same(files.reference, verdict.reference, "reference");
  check_same(files.object, verdict.object, "object");
  check_same(files.path, verdict.path, "tool path");
  if (files.adapted.empty()) return;
  if (!verdict.accepted) {
    throw UnusableInput(files.adapted, "an adapted path, but the report is of a refused one",
                        "leave --adapted out");
  }
  check_same(files.adapted, verdict.output, "adapted path");
}

void check_figures(const PictureInput& input) {
  const ReportedVerdict& verdict = input.verdict;
  if (!verdict.reference) check_points(input.reference, verdict.reference_points, "reference");
  if (!verdict.object) check_points(input.object, verdict.object_points, "object");
  if (!verdict.path && verdict.waypoints_given > 0)
    check_waypoints(input.path, verdict.waypoints_given, "tool path");
  if (!verdict.output && input.adapted) check_displacements(input);
}

}  // namespace tool_path_stretcher
