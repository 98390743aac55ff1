// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "board/rendered_board.h"
#include "scan_calibration/session.h"

/// A session of a rendered board, and its ground truth.
struct RenderedSession {
  scan_calibration::Board board{9, 6, 0.02};
  scan_cell_common::ScannerModel truth;
  Eigen::Isometry3d base_to_board = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> boards_in_camera;

  Eigen::Isometry3d base_to_flange(std::size_t view) const;
};

/// A camera of 640 x 480 pixels with two laser planes that cross at 0.3 m, and views of the board
/// from 0.26 to 0.4 m, tilted by up to 35 degrees in all directions.
RenderedSession example_session(int views);

/// Renders its images and writes them to a folder: the board under the room's light, then each
/// laser alone.
/// @param lasers_in_board_image the first laser is also on in the image of the board, which is
/// dark; no other image is taken
/// @param samples of a pixel, squared
/// @param names of the lasers that are on in turn
void record(const RenderedSession& session, const std::string& folder,
            bool laser_in_board_image = false, int samples = 3,
            const std::vector<std::string>& names = {"laser_0", "laser_1"});
