// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "checks/diagnosis.h"
#include "estimate/camera_fit.h"
#include "scan_calibration/calibration.h"

namespace scan_calibration {

/// A camera that is kept, checked against the views of a session.
class KnownCamera {
 public:
  /// @throw scan_cell_common::UnusableInput if the images have another size
  KnownCamera(const ExistingScanner& existing, const Observations& observations);

  /// The board's pose in each view.
  CameraFit fit(BoardViews& views) const;

  /// @param fit of these views
  /// @throw scan_cell_common::UnusableInput if a camera fitted to the views explains them far
  /// better
  void check_lens(const BoardViews& views, const CameraFit& fit);

  /// The board's pose from the camera's pose on the flange.
  /// @throw scan_cell_common::UnusableInput as agreed_hand_eye() and check_board_size(), or if a
  /// pose fitted to the views explains them far better
  HandEye hand_eye(const PosePairs& pairs);

  /// How well the views fit it, in words.
  const std::string& note() const { return note_; }

 private:
  const ExistingScanner& existing_;
  const Board board_;
  const BoardSurface surface_;
  std::string note_;
};

}  // namespace scan_calibration
