// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

namespace scan_cell_sim {

/// Part of the sensor that is read out [px].
struct Region {
  int x = 0;       //!< first column
  int y = 0;       //!< first row
  int width = 0;   //!< columns
  int height = 0;  //!< rows
};

/// How light becomes grey values.
struct Optics {
  double stripe_sigma = 2.2;  //!< [px] Gaussian cross-section of the line on the sensor
  /// [grey value] peak on a white surface 0.5 m from the projector, at normal incidence, at
  /// `exposure`
  double brightness = 300;
  double exposure = 0.001;  //!< [s] to which `brightness` refers
  double background = 6;    //!< [grey value] dark level and stray light
  /// [grey value] of a white surface in ambient light, at `exposure`
  double ambient = 4;
  double read_noise = 1.2;   //!< [grey value] standard deviation
  double shot_noise = 0.35;  //!< standard deviation over the root of the stripe's grey value
  std::uint64_t seed = 1;    //!< the same seed and frame give the same image
};

/// What the camera sees in one frame.
struct Exposure {
  Eigen::Isometry3d camera = Eigen::Isometry3d::Identity();  //!< camera_optical_frame in world
  std::uint8_t lasers = 0;                                   //!< bit mask: 1 laser_0, 2 laser_1
  double duration = 0.001;                                   //!< [s]
  double gain = 1;                                           //!< factor
  std::uint64_t frame = 0;                                   //!< number that seeds the noise
  std::array<double, 2> light = {1, 1};  //!< share of `duration` for which each of `lasers` is on
};

}  // namespace scan_cell_sim
