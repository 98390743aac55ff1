// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_stretcher/similarity.h"

namespace cases {

using tool_path_stretcher::Points;
using tool_path_stretcher::Similarity;

/// Two clouds and the pose of the second relative to the first. Points with the same index
/// correspond, unless points were added or moved.
struct Pair {
  Points reference;
  Points object;
  Similarity truth;
};

bool has_registration_data(const std::string& data);

/// A real lidar cloud, and the same cloud scaled by 1.04 and rotated by 0.2 rad (libpointmatcher's
/// examples). The truth is fitted to the points, row by row.
/// @param data folder with registration/car
/// @throw std::runtime_error if it has no such clouds
Pair car_pair(const std::string& data);

/// The Stanford bunny as in TEASER's example: moved, with uniform noise of up to 0.0005; then draws
/// with replacement, each adding an integer of 5 to 10 to all three coordinates of a point.
/// @param data folder with registration/bunny
Pair bunny_pair(const std::string& data, std::size_t draws);

/// Angle of the rotation [rad].
double angle_of(const Eigen::Matrix3d& rotation);

}  // namespace cases
