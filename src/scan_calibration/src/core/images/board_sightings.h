// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "images/board_detection.h"
#include "scan_calibration/observations.h"

namespace scan_calibration {

/// What the board image of one view shows.
struct BoardSighting {
  cv::Size size;         //!< [px] of the image; empty: it cannot be read
  BoardCorners corners;  //!< empty: not usable
  std::string reason;    //!< why not
};

/// Looks for the board in every view of the session. Leaves out views that are unreadable, have
/// another image size than most, do not show the board, or repeat a pose.
std::vector<BoardSighting> find_boards(const Session& session, const ObservationOptions& options);

/// @throw scan_cell_common::UnusableInput if no view shows the board, or several show a larger one
void check_board_size(const Session& session, const std::vector<BoardSighting>& views);

}  // namespace scan_calibration
