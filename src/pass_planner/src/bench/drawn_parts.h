// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "pass_planner/part.h"
#include "pass_planner/sweep.h"
#include "scan_cell_sim/tool_paths.h"
#include "scan_cell_sim/world.h"

namespace pass_planner {

/// A number between two bounds, the same on every machine: the library's distributions differ.
double draw(std::mt19937_64& random, double least, double most);

/// A part of the simulator somewhere on the floor, with a path as taught on the reference.
struct DrawnPart {
  std::string name;                   //!< of its shape
  scan_cell_sim::World world;         //!< the floor and the part on it
  scan_cell_sim::Part reference;      //!< the same at the origin, in its own size
  scan_cell_sim::ToolPath path;       //!< on the reference
  scan_cell_sim::ToolPath true_path;  //!< on the part
};

/// Frames with a path on the crest of their moulding, and frames, boxes and elbows with a path
/// around their flanks; size, scale, place and turn are drawn.
DrawnPart draw_part(std::uint64_t seed);

/// A line over the middle of the cell, straight down or leaning a little, with one laser or both.
scan_cell::ScanPass draw_line(std::uint64_t seed);

/// A mesh of the simulator as the planner takes it.
SurfaceShape shape_of(const scan_cell_sim::Mesh& mesh);

std::vector<Eigen::Vector3d> positions_of(const scan_cell_sim::ToolPath& path);

}  // namespace pass_planner
