// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "images/board_detection.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_calibration {

/// A camera from some of the corners of some of the views, good enough to recognize a straight line
/// and the way a board is turned.
/// @param views at least three of them not empty
/// @throw scan_cell_common::UnusableInput if the views do not determine a camera
scan_cell_common::CameraIntrinsics rough_camera(const std::vector<BoardCorners>& views,
                                                const Board& board, int width, int height);

/// Pose of the board in camera_optical_frame [m].
Eigen::Isometry3d rough_board_pose(const scan_cell_common::CameraIntrinsics& camera,
                                   const BoardCorners& corners, const Board& board);

}  // namespace scan_calibration
