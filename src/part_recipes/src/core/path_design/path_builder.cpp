// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/path_builder.h"

#include <fmt/format.h>

#include <algorithm>

#include "path_design/surface/reference.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

PathBuilder::PathBuilder(const PathParameters& parameters)
    : steps_{parameters.chord, parameters.max_step},
      speed_(parameters.speed),
      min_length_(parameters.min_length) {
  pose_.stand_off = parameters.stand_off;
  pose_.z = parameters.waypoint_z;
  pose_.corner_angle = parameters.corner_angle;
  if (!parameters.tool_x.empty()) pose_.x = Eigen::Vector3d(parameters.tool_x.data()).normalized();
  result_.path.has_orientation = true;
  if (speed_ > 0) result_.path.process_names = {"speed"};
}

void PathBuilder::add(const path_design::Trace& trace, const std::string& name) {
  const double length = length_of(trace);
  if (length < min_length_ || !(length > 0)) {
    ++left_out_;
    return;
  }
  tool_paths::Segment segment = waypoints_of(stepped(trace, steps_), pose_, name);
  for (tool_paths::Waypoint& waypoint : segment.waypoints)
    if (speed_ > 0) waypoint.process_values = {speed_};
  result_.path.segments.push_back(std::move(segment));
}

DesignedPath PathBuilder::finish(const std::string& what) {
  if (left_out_ > 0)
    note(fmt::format("left out: {} of {} segments, shorter than {:g} mm", left_out_,
                     left_out_ + result_.path.segments.size(), 1e3 * min_length_));
  if (result_.path.segments.empty())
    throw scan_cell_common::Refused(what, "none on this surface",
                                    "check margin, offset, min_length and from");
  tool_paths::check(result_.path);
  return std::move(result_);
}

double filled_width(const path_design::PartMesh& reference, const PathParameters& parameters) {
  constexpr double kCloudsOwn = 3;  // spacings: as far as a cloud's points are joined
  return std::max(parameters.gap, kCloudsOwn * reference.spacing);
}

path_design::PartMesh load_reference_surface(const std::string& file, double metres_per_unit,
                                             const PathParameters& parameters) {
  return path_design::load_reference(
      file, metres_per_unit,
      {parameters.leaf, parameters.from.normalized(), parameters.crease_angle});
}

}  // namespace part_recipes
