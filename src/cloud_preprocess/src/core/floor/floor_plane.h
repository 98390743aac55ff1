// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "cloud_preprocess/floor_removal.h"
#include "geometry/plane_search.h"

namespace cloud_preprocess {

struct Floor {
  Plane plane;         //!< its normal is upwards
  std::size_t points;  //!< of the sample, on it
};

/// The floor as FloorRemoval describes it; none if the cloud shows none.
/// @param up of length 1
std::optional<Floor> find_floor(const OrientedPoints& sample, const Eigen::Vector3d& up,
                                const FloorParameters& parameters);

/// The plane in any direction that looks like a table: nothing lies behind it, and it reaches
/// beyond most of what lies before it without lying below that. So none of the sides of a box is
/// one.
std::optional<Floor> find_table(const OrientedPoints& sample, const FloorParameters& parameters);

/// How many points each object of the sample has, the largest first: clusters that are 10 mm, and
/// clearly more than their points, apart from each other, each with a floor's least share.
std::vector<std::size_t> find_objects(const OrientedPoints& sample,
                                      const FloorParameters& parameters);

}  // namespace cloud_preprocess
