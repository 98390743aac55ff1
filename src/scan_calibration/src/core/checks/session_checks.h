// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/board_view.h"

namespace scan_calibration {

constexpr std::size_t kMinViews = 6;  //!< for an estimate; chosen

/// The views that can be used at all.
struct UsableViews {
  BoardViews views;
  std::vector<RejectedView> rejected;
};

/// Leaves out, by name, views that show too little of the board or repeat another view.
/// @throw scan_cell_common::UnusableInput if the observations contradict themselves, or too few
/// views are left
UsableViews usable_views(const Observations& observations);

/// The same for a camera alone: the robot's poses are not checked.
UsableViews usable_board_views(const Observations& observations);

/// @throw scan_cell_common::UnusableInput if fewer views than kMinViews are left
void check_enough(const BoardViews& views, const std::vector<RejectedView>& rejected);

/// @throw scan_cell_common::UnusableInput naming a laser that shows in too few views
void check_lasers_seen(const Observations& observations, const BoardViews& views);

}  // namespace scan_calibration
