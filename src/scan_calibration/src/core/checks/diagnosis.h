// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checks/hand_eye.h"
#include "geometry/board_view.h"

namespace scan_calibration {

/// The poses of each view, by the robot and by the camera.
struct PosePairs {
  std::vector<std::string> names;
  std::vector<Eigen::Isometry3d> flange;  //!< base_to_flange [m]
  std::vector<Eigen::Isometry3d> board;   //!< camera_to_board [m]
};

/// Whether most of `of` views agree on where the camera sits on the flange.
bool agree(const HandEye& found, std::size_t of);

/// @throw scan_cell_common::UnusableInput if the board was held at one tilt in all views
void check_tilts(const PosePairs& pairs);

/// Hand-eye of poses that belong together.
/// @throw scan_cell_common::UnusableInput if most poses do not agree with the images, saying what
/// is wrong with them (out of step, wrong unit, inverted) or what they leave undetermined
HandEye agreed_hand_eye(const PosePairs& pairs, const BoardSurface& surface);

/// @param square_size [m] as given
/// @throw scan_cell_common::UnusableInput if the robot's travel gives another size, which it names
void check_board_size(const HandEye& hand_eye, const PosePairs& pairs, double square_size);

}  // namespace scan_calibration
