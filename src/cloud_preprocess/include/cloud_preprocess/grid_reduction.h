// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cloud_preprocess/stage.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace cloud_preprocess {

/// Parameters of the stage grid; see docs/cloud_preprocess.md.
struct GridParameters {
  Eigen::Vector3d leaf{0.002, 0.002, 0.0005};  //!< [m] size of a cell along x, y, z
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, GridParameters& parameters);

/// Replaces the points in each occupied cell of a grid through the frame's origin by their mean.
/// The output is ordered by z, then y, then x of the cell. Unlike in PCL's VoxelGrid, no index
/// overflows for a cloud of large extent; a point beyond a million cells is refused.
class GridReduction final : public Stage {
 public:
  using Parameters = GridParameters;  //!< parameters of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit GridReduction(const GridParameters& parameters);

  std::string name() const override { return "grid"; }  //!< name of the stage

 private:
  std::string apply(TracedCloud& cloud) const override;

  GridParameters parameters_;
};

}  // namespace cloud_preprocess
