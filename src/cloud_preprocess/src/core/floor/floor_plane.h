// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cloud_preprocess/floor_removal.h"
#include "geometry/plane_search.h"

namespace cloud_preprocess {

struct Floor {
  Plane plane;         //!< with its normal upwards
  std::size_t points;  //!< points of the sample on it
};

/// The floor as defined by FloorRemoval; none if the cloud shows none.
/// @param up unit length
std::optional<Floor> find_floor(const OrientedPoints& sample, const Eigen::Vector3d& up,
                                const FloorParameters& parameters);

/// The plane in any direction that looks like a table: nothing lies behind it, and it extends
/// beyond most of what is in front of it and is mostly not covered by that. So no side of a box
/// qualifies.
std::optional<Floor> find_table(const OrientedPoints& sample, const FloorParameters& parameters);

/// The number of points of each object in the sample, largest first. Objects are clusters at least
/// 10 mm apart, and clearly farther apart than their points, each with at least a floor's least
/// share.
std::vector<std::size_t> find_objects(const OrientedPoints& sample,
                                      const FloorParameters& parameters);

}  // namespace cloud_preprocess
