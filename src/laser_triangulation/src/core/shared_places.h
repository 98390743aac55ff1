// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "scan_cloud.h"

namespace laser_triangulation {

/// One laser's points of one pass.
struct Sweep {
  std::uint8_t pass = 0;   //!< from 0
  std::uint8_t laser = 0;  //!< its index
};

/// For a person: "pass 2 laser_1".
std::string name_of(const Sweep& sweep);

/// What one sweep has near a place.
struct SweepPatch {
  std::size_t sweep = 0;    //!< index into SharedPlaces::sweeps
  Eigen::Vector3d nearest;  //!< [m] its point that is nearest to the place
  Eigen::Vector3d from;     //!< [m] where the camera saw that point from
  /// Whether its surface lies flat and all around the place; no edge, no rim of a shadow.
  bool whole = false;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();    //!< [m] of a whole patch
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  //!< of a whole patch
};

/// Whether a patch was seen from the side of a whole patch that this was seen from. Otherwise they
/// are front and back of a wall or a sheet.
bool same_side(const SweepPatch& whole, const SweepPatch& other);

/// Places that are spread over the cloud, and what each sweep has there.
struct SharedPlaces {
  static constexpr double kReach = 2e-3;  //!< [m] of a patch around its place; chosen
  /// [m] that a sweep is looked for around a place; chosen: further off it is another surface
  static constexpr double kSearch = 5e-3;

  std::vector<Sweep> sweeps;                    //!< by pass, then by laser
  std::vector<Eigen::Vector3d> centres;         //!< [m] of the places
  std::vector<std::vector<SweepPatch>> places;  //!< each by sweep
};

/// Takes a part of the points where there are many, in one go through the cloud: the time grows
/// neither with the size of a large cloud nor with the number of its sweeps. Empty where there is
/// one sweep.
SharedPlaces find_shared_places(const ScanCloud& cloud);

/// Places in the cells of a grid, each in every cell that its search reaches: a point finds all its
/// places in one cell.
class PlaceGrid {
 public:
  explicit PlaceGrid(const std::vector<Eigen::Vector3d>& centres);

  /// Indices of the places within kSearch of a point, and of some that are further off.
  const std::vector<std::size_t>& near(const Eigen::Vector3d& point) const;

 private:
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;  // only looked up
};

}  // namespace laser_triangulation
