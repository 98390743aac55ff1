// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cloud_preprocess/stage.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace cloud_preprocess {

/// Of the stage grid; docs/cloud_preprocess.md.
struct GridParameters {
  Eigen::Vector3d leaf{0.002, 0.002, 0.0005};  //!< [m] size of a cell along x, y, z
};

/// Each with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, GridParameters& parameters);

/// Puts the mean of its points in place of each occupied cell of a grid through the frame's origin.
/// Points come out ordered by z, then y, then x of their cell. A cloud of any extent is reduced:
/// there is no index to overflow as in PCL's VoxelGrid; a point beyond a million cells is refused.
class GridReduction final : public Stage {
 public:
  using Parameters = GridParameters;  //!< of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit GridReduction(const GridParameters& parameters);

  std::string name() const override { return "grid"; }  //!< of the stage

 private:
  std::string apply(TracedCloud& cloud) const override;

  GridParameters parameters_;
};

}  // namespace cloud_preprocess
