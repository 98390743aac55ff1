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

/// The points of one sweep near a place.
struct SweepPatch {
  std::size_t sweep = 0;    //!< index into SharedPlaces::sweeps
  Eigen::Vector3d nearest;  //!< [m] its point nearest to the place
  Eigen::Vector3d from;     //!< [m] where the camera was when it saw that point
  /// Whether its surface is flat and lies all around the place, without an edge or a rim of a
  /// shadow.
  bool whole = false;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();    //!< [m] of a whole patch
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  //!< of a whole patch
};

/// Whether a patch was seen from the same side of the surface as a whole patch. Otherwise they are
/// front and back of a wall or a sheet.
bool same_side(const SweepPatch& whole, const SweepPatch& other);

/// Places spread over the cloud, with the patch of each sweep there.
struct SharedPlaces {
  static constexpr double kReach = 2e-3;  //!< [m] radius of a patch around its place; chosen
  /// [m] radius in which a sweep is searched around a place; farther off is another surface; chosen
  static constexpr double kSearch = 5e-3;

  std::vector<Sweep> sweeps;                    //!< by pass, then by laser
  std::vector<Eigen::Vector3d> centres;         //!< [m] of the places
  std::vector<std::vector<SweepPatch>> places;  //!< patches at each place, by sweep
};

/// Goes through the cloud once, and uses only a part of the points of a large one. The time grows
/// neither with the size of a large cloud nor with the number of sweeps. Empty if there is only one
/// sweep.
SharedPlaces find_shared_places(const ScanCloud& cloud);

/// Places in the cells of a grid. Each place is in every cell that its search radius reaches, so a
/// point finds all its places in one cell.
class PlaceGrid {
 public:
  explicit PlaceGrid(const std::vector<Eigen::Vector3d>& centres);

  /// Indices of the places within kSearch of a point, and of some farther off.
  const std::vector<std::size_t>& near(const Eigen::Vector3d& point) const;

 private:
  std::unordered_map<std::uint64_t, std::vector<std::size_t>>
      cells_;  // never iterated, so the order does not matter
};

}  // namespace laser_triangulation
