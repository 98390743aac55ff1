// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "scan_calibration/session.h"

namespace scan_calibration {

/// An inner corner of the board and where it was seen.
struct SeenCorner {
  int column = 0;         //!< 0 .. columns - 1
  int row = 0;            //!< 0 .. rows - 1
  Eigen::Vector2d pixel;  //!< [px] whole sensor, pixel centres are whole numbers
};

/// What was seen at one pose.
struct ViewObservation {
  std::string name;
  Eigen::Isometry3d base_to_flange;  //!< [m]
  std::vector<SeenCorner> corners;
  /// A laser, then points along its line on the board's plane [px]; empty: not seen.
  std::vector<std::vector<Eigen::Vector2d>> lines;
};

/// A view, or a laser's line in it, that is not used, and why.
struct RejectedView {
  std::string name;   //!< of the view
  std::string laser;  //!< empty: the whole view
  std::string reason;
};

/// What a session shows, as far as it could be read from its images.
struct Observations {
  int width = 0;   //!< [px] of the sensor
  int height = 0;  //!< [px]
  Board board;
  std::vector<std::string> lasers;
  std::vector<ViewObservation> views;
  std::vector<RejectedView> rejected;
};

}  // namespace scan_calibration
