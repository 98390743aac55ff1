// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/describe.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

struct GridParameters {
  Eigen::Vector3d leaf{0.002, 0.002, 0.0005};  //!< [m] size of a cell along x, y, z
};

template <class Reader>
void describe(Reader& reader, GridParameters& parameters) {
  describe_vector(reader, "leaf", parameters.leaf, {1e-5, 1});
}

/// Puts the mean of its points in place of each occupied cell of a grid through the frame's origin.
/// Points come out ordered by z, then y, then x of their cell. A cloud of any extent is reduced:
/// there is no index to overflow as in PCL's VoxelGrid; a point beyond a million cells is refused.
class GridReduction final : public Stage {
 public:
  using Parameters = GridParameters;

  /// @throw scan_cell_common::InvalidParameter
  explicit GridReduction(const GridParameters& parameters);

  std::string name() const override { return "grid"; }

 private:
  std::string apply(Cloud& cloud) const override;

  GridParameters parameters_;
};

}  // namespace cloud_preprocess
