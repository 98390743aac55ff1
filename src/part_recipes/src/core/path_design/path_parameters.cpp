// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/path_parameters.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "scan_cell_common/parameters/parameter_table.h"

namespace part_recipes {
namespace {

using scan_cell_common::Also;
using scan_cell_common::ParameterTable;

Eigen::Vector3d to_vector(const std::vector<double>& numbers) {
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

/// Directions stay the same in files of other units and at any length.
void check_direction(const ParameterTable& table, const std::string& name,
                     const Eigen::Vector3d& direction) {
  if (!direction.isZero(1e-9)) return;  // [1] shorter than any that is meant
  table.refuse(name, fmt::format("{} {} {}", direction.x(), direction.y(), direction.z()),
               "give a direction that is not zero");
}

void describe(ParameterTable& table, PathParameters& p) {
  constexpr double kMost = 1e3;
  table.add("from", p.from, {-kMost, kMost},
            "direction from the part to the viewer: only the side seen from there counts");
  table.add("chord", p.chord, {1e-6, 0.1, "m"},
            "largest distance of the line between two waypoints from the surface");
  table.add("max_step", p.max_step, {1e-4, 10, "m"}, "largest distance between two waypoints");
  table.add("stand_off", p.stand_off, {-1, 1, "m"},
            "distance of the waypoints from the surface, along its normal");
  table.add("tool_x", p.tool_x, {-kMost, kMost},
            "direction of the tool's x axis; empty: along the travel", 3);
  table.choice("waypoint_z", p.waypoint_z, {"into_part", "out_of_part"},
               "where the z axis of the waypoints points");
  table.add("speed", p.speed, {1e-6, 100, "m/s", Also::kZero},
            "written with each waypoint as the process value `speed`; 0: none");
  table.add(
      "gap", p.gap, {0, 10, "m"},
      "holes up to this wide count as filled; a cloud's own gaps of three spacings always do");
  table.add("min_length", p.min_length, {0, 100, "m"}, "shorter segments are left out");
  table.add("crease_angle", p.crease_angle, {0.01, 3.15, "rad"},
            "angle between facets above which an edge of a mesh is sharp");
  table.add("corner_angle", p.corner_angle, {0.01, 3.15, "rad"},
            "angle above which a turn of the path is a corner");
  table.add("leaf", p.leaf, {1e-5, 1, "m"}, "grid on which a cloud is reduced");
  check_direction(table, "from", p.from);
  if (!p.tool_x.empty()) check_direction(table, "tool_x", to_vector(p.tool_x));
}

}  // namespace

void describe(ParameterTable& table, EdgeParameters& p) {
  table.add("offset", p.offset, {-1, 1, "m"},
            "distance from the edge, inwards along the surface; below 0: outwards, straight on");
  table.add("near", p.near, {-1e3, 1e3, "m"},
            "a place on the face whose edge is meant; empty: all that is seen", 3);
  table.choice("loops", p.loops, {"all", "outer", "holes"}, "which edges are followed");
  table.add("smoothing", p.smoothing, {1e-5, 1, "m", Also::kZero},
            "length to each side over which the edge is smoothed; 0: four spacings of a cloud, "
            "none of a mesh");
  describe(table, p.path);
}

void describe(ParameterTable& table, SliceParameters& p) {
  table.add("spacing", p.spacing, {1e-5, 10, "m"}, "distance between the rows");
  table.add("direction", p.direction, {-1e3, 1e3},
            "direction of the rows; empty: the longest axis of the part", 3);
  table.add("angle", p.angle, {-3.15, 3.15, "rad"},
            "angle by which the rows are turned from their direction, about the viewer's");
  table.choice("order", p.order, {"zigzag", "one_way"},
               "zigzag: rows are linked where the surface continues; one_way: each is a segment");
  table.add("margin", p.margin, {0, 1, "m"}, "distance kept from the border, along the surface");
  table.add("border_passes", p.border_passes, {0, 100},
            "passes along the border: the first at the margin, then a spacing apart");
  describe(table, p.path);
  if (p.direction.empty()) return;
  const Eigen::Vector3d direction = to_vector(p.direction);
  check_direction(table, "direction", direction);
  constexpr double kAlong = 0.02;  // sine: about 1 degree; chosen
  if (direction.normalized().cross(p.path.from.normalized()).norm() < kAlong)
    table.refuse("direction", "along the viewer's direction", "give one across `from`");
}

void describe(ParameterTable& table, PickParameters& p) {
  table.add("max_distance", p.max_distance, {1e-6, 1, "m"},
            "largest distance of a pick, and of the line between picks, from the surface");
  table.add("closed", p.closed, "the path returns from the last pick to the first");
  describe(table, p.path);
}

}  // namespace part_recipes
