// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scan_cell_sim/checkerboard.h"
#include "scan_cell_sim/part.h"

namespace scan_cell_sim {

/// The floor, a level rectangle centred on the world's origin.
struct Floor {
  double height = 0;                  //!< [m]
  Eigen::Vector2d size = {1.6, 1.6};  //!< [m]
  double reflectance = 0.5;           //!< 0 .. 1, diffuse
};

/// Everything in the cell. Its frame is `world`, z up.
struct World {
  std::optional<Floor> floor;         //!< if there is one
  std::optional<Checkerboard> board;  //!< if there is one
  std::vector<Part> parts;            //!< each with its own name

  /// @throw scan_cell_common::UnusableInput if no part has this name
  const Part& part(const std::string& name) const;
};

/// Reads a world file (docs/scan_cell_sim.md).
/// @throw scan_cell_common::FileError if it is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing or invalid
World load_world(const std::string& path);

}  // namespace scan_cell_sim
