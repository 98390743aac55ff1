// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/part.h"

#include <fmt/format.h>

#include <numeric>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "tool_path_stretcher/reported_verdict.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_paths/tool_path_files.h"

namespace pass_planner {
namespace {

using scan_cell_common::UnusableInput;
using tool_path_stretcher::FileRecord;
using tool_path_stretcher::ReportedVerdict;

/// @param metres per unit of the file
void check_same(const std::string& file, double metres, const std::optional<FileRecord>& reported,
                const std::string& report) {
  if (!reported) return;
  if (scan_cell_common::metres_per(reported->units) != metres) {
    throw UnusableInput(file, fmt::format("read in units of {:g} m", metres),
                        fmt::format("give its unit as in {}: {}", report, reported->units));
  }
  if (tool_path_stretcher::record_of(file, reported->units).sha256 == reported->sha256) return;
  throw UnusableInput(file, "not the file that " + report + " is about",
                      "give " + reported->name + ", unchanged since then");
}

void place_as_reported(const PartFiles& files, PlacedPart& part) {
  const ReportedVerdict verdict = tool_path_stretcher::load_report(files.report);
  check_same(files.reference, files.reference_metres, verdict.reference, files.report);
  check_same(files.path, scan_cell_common::metres_per(files.path_units), verdict.path,
             files.report);
  if (verdict.similarities.empty()) {
    throw UnusableInput(files.report, "has no pose of the part (" + verdict.reason + ")",
                        "give the report of a run that found the part");
  }
  const tool_path_stretcher::Similarity& similarity = verdict.similarities.front();
  part.shape = placed(part.shape, similarity);
  for (Eigen::Vector3d& waypoint : part.waypoints)
    waypoint = similarity * waypoint;
  if (verdict.waypoints.empty()) return;
  for (const std::size_t waypoint : verdict.waypoints) {
    if (waypoint < part.waypoints.size()) continue;
    throw UnusableInput(files.report, fmt::format("names waypoint {}", waypoint),
                        fmt::format("give the path it is about: {} has {} waypoints", files.path,
                                    part.waypoints.size()));
  }
  part.wanted = verdict.waypoints;
}

}  // namespace

PlacedPart load_part(const PartFiles& files) {
  PlacedPart part;
  part.shape = load_shape(files.reference, tool_path_stretcher::StretchParameters().leaf,
                          files.reference_metres);
  tool_paths::PathConventions conventions;
  conventions.units = files.path_units;
  const auto path = tool_paths::load_tool_path(files.path, conventions);
  for (const tool_paths::Segment& segment : path.segments) {
    for (const tool_paths::Waypoint& waypoint : segment.waypoints)
      part.waypoints.push_back(waypoint.pose.translation());
  }
  part.wanted.resize(part.waypoints.size());
  std::iota(part.wanted.begin(), part.wanted.end(), 0);
  if (!files.report.empty()) place_as_reported(files, part);
  return part;
}

std::vector<Surface::Place> places_of(const std::vector<Eigen::Vector3d>& waypoints,
                                      const Surface& surface) {
  std::vector<std::size_t> all(waypoints.size());
  std::iota(all.begin(), all.end(), 0);
  return places_of(waypoints, surface, all);
}

std::vector<Surface::Place> places_of(const std::vector<Eigen::Vector3d>& waypoints,
                                      const Surface& surface,
                                      const std::vector<std::size_t>& wanted) {
  constexpr double kFar = 0.02;  // [m] as the stretcher's max_stand_off
  std::vector<Surface::Place> places;
  for (const std::size_t i : wanted) {
    places.push_back(surface.nearest(waypoints[i]));
    if (places.back().distance <= kFar) continue;
    throw UnusableInput(fmt::format("waypoint {}", i),
                        fmt::format("{:.4g} mm off the surface", 1e3 * places.back().distance),
                        "give path and part in the same frame and unit");
  }
  return places;
}

}  // namespace pass_planner
