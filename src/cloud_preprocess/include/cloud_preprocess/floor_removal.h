// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// Parameters of the stage floor; see docs/cloud_preprocess.md.
struct FloorParameters {
  bool automatic = true;    //!< look for the floor; false: only the limits cut
  double margin = 0.002;    //!< [m] points up to this above the floor go with it
  double distance = 0.001;  //!< [m] how far points of the floor may lie from its plane
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  //!< away from the floor, of any length
  bool any_direction = false;  //!< look for a table in any direction; if there is none, along `up`
  double tilt = 0.26;          //!< [rad] how far the floor's normal may lean from `up`
  double min_share = 0.02;     //!< share of all points that a floor must have
  double max_below = 0.01;     //!< share of all points that may lie below a floor
  Limits limits;               //!< by hand, cut before all else
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, FloorParameters& parameters);

/// Removes the floor and everything below it. The floor is the plane perpendicular to `up`, at the
/// bottom of the cloud, that reaches the edge of the scan. The top of a box has its sides below it,
/// and a flat face inside a frame does not reach the edge, so neither is taken for the floor.
/// Without such a plane nothing is removed, and the report says so.
///
/// A cloud is refused if this would remove the part and keep the table: a plane in another
/// direction looks like a table, or several objects stand there and no floor is found. It is not
/// refused if a limit by hand has already cut the floor away.
class FloorRemoval final : public Stage {
 public:
  using Parameters = FloorParameters;  //!< parameters of this stage

  /// @throw scan_cell_common::InvalidParameter
  explicit FloorRemoval(const FloorParameters& parameters);

  std::string name() const override { return "floor"; }  //!< name of the stage

 private:
  /// @throw scan_cell_common::UnusableInput if the floor seems to be elsewhere
  std::string apply(TracedCloud& cloud) const override;

  FloorParameters parameters_;
};

}  // namespace cloud_preprocess
