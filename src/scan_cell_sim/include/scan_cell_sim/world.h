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

/// All that stands in the cell. Its frame is `world`, z up.
struct World {
  std::optional<Floor> floor;         //!< none: there is no floor
  std::optional<Checkerboard> board;  //!< none: there is no board
  std::vector<Part> parts;            //!< with names of their own

  /// @throw scan_cell_common::UnusableInput if no part has this name
  const Part& part(const std::string& name) const;
};

/// Reads a world file (docs/scan_cell_sim.md).
/// @throw scan_cell_common::FileError if it is missing or not YAML
/// @throw scan_cell_common::UnusableInput naming the entry that is missing or makes no sense
World load_world(const std::string& path);

}  // namespace scan_cell_sim
