// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/limits.h"
#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

struct FloorParameters {
  bool automatic = true;    //!< look for the floor; false: only the limits cut
  double margin = 0.002;    //!< [m] points up to this above the floor go with it
  double distance = 0.001;  //!< [m] how far points of the floor may lie from its plane
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  //!< away from the floor, of any length
  bool any_direction = false;  //!< look for a table in any direction; where none is, along `up`
  double tilt = 0.26;          //!< [rad] how far the floor's normal may lean from `up`
  double least_share = 0.02;   //!< of all points, that a floor must have
  double most_below = 0.01;    //!< of all points, that may lie below a floor
  Limits limits;
};

/// @throw scan_cell_common::InvalidParameter where `up` is no direction
void check_up(const Eigen::Vector3d& up);

template <class Reader>
void describe(Reader& reader, FloorParameters& parameters) {
  using Range = typename Reader::Range;
  reader.read("automatic", parameters.automatic);
  reader.read("margin", parameters.margin, Range{0, 1});
  reader.read("distance", parameters.distance, Range{1e-5, 0.1});
  describe_vector(reader, "up", parameters.up, {-1e3, 1e3});
  check_up(parameters.up);
  reader.read("any_direction", parameters.any_direction);
  reader.read("tilt", parameters.tilt, Range{1e-3, 0.7});
  reader.read("least_share", parameters.least_share, Range{1e-3, 1});
  reader.read("most_below", parameters.most_below, Range{0, 0.5});
  describe(reader, parameters.limits);
}

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
  using Parameters = FloorParameters;

  /// @throw scan_cell_common::InvalidParameter
  explicit FloorRemoval(const FloorParameters& parameters);

  std::string name() const override { return "floor"; }

 private:
  /// @throw scan_cell_common::UnusableInput where the floor seems to be elsewhere
  std::string apply(Cloud& cloud) const override;

  FloorParameters parameters_;
};

}  // namespace cloud_preprocess
