// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// Of the stage floor; docs/cloud_preprocess.md.
struct FloorParameters {
  bool automatic = true;    //!< look for the floor; false: only the limits cut
  double margin = 0.002;    //!< [m] points up to this above the floor go with it
  double distance = 0.001;  //!< [m] how far points of the floor may lie from its plane
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  //!< away from the floor, of any length
  bool any_direction = false;  //!< look for a table in any direction; where none is, along `up`
  double tilt = 0.26;          //!< [rad] how far the floor's normal may lean from `up`
  double min_share = 0.02;     //!< of all points, that a floor must have
  double max_below = 0.01;     //!< of all points, that may lie below a floor
  Limits limits;               //!< by hand, cut before all else
};

/// Each with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, FloorParameters& parameters);

/// Removes the floor: the plane across `up` at the bottom of the cloud that reaches the edge of
/// what was scanned, with everything below it. The top of a box has its sides below it, and a flat
/// inside a frame does not reach the edge, so neither is taken. Without such a plane nothing is
/// removed, and the report says so.
///
/// A cloud is refused where that would throw away the part and keep the table: a plane in another
/// direction looks like a table, or several objects stand there and no floor is found. Not so where
/// a limit by hand has cut the floor away already.
class FloorRemoval final : public Stage {
 public:
  using Parameters = FloorParameters;  //!< of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit FloorRemoval(const FloorParameters& parameters);

  std::string name() const override { return "floor"; }  //!< of the stage

 private:
  /// @throw scan_cell_common::UnusableInput where the floor seems to be elsewhere
  std::string apply(TracedCloud& cloud) const override;

  FloorParameters parameters_;
};

}  // namespace cloud_preprocess
