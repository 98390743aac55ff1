// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/known_camera.h"

#include <cmath>

#include "geometry/statistics.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kFarBetter = 3;  // times what is left to explain

/// Typical of the views that fit, along an axis.
struct Scatter {
  explicit Scatter(const HandEye& found) {
    constexpr double kChi3 = 1.5382;  // median length of a vector of unit noise
    std::vector<double> offsets, angles;
    for (std::size_t i = 0; i < found.fits.size(); ++i) {
      if (!found.fits[i]) continue;
      offsets.push_back(found.offset[i]);
      angles.push_back(found.angle[i]);
    }
    position = median(offsets) / kChi3;
    angle = median(angles) / kChi3;
  }

  std::string text() const {
    return figure(position * 1e3, " mm") + " and " + figure(angle * 180 / M_PI, " deg");
  }

  double position = 0;  // [m]
  double angle = 0;     // [rad]
};

}  // namespace

KnownCamera::KnownCamera(const ExistingScanner& existing, const Observations& observations)
    : existing_(existing), board_(observations.board), surface_(observations.board) {
  const scan_cell_common::CameraIntrinsics& camera = existing.model.camera;
  if (camera.width == observations.width && camera.height == observations.height) return;
  throw UnusableInput("camera of " + existing.file,
                      std::to_string(camera.width) + " x " + std::to_string(camera.height) +
                          " pixels; the images have " + std::to_string(observations.width) + " x " +
                          std::to_string(observations.height),
                      "it is another camera: calibrate it too");
}

CameraFit KnownCamera::fit(BoardViews& views) const {
  return fit_near(views, surface_, existing_.model.camera, true);
}

void KnownCamera::check_lens(const BoardViews& views, const CameraFit& fit) {
  constexpr double kMinded = 0.3;  // [px] below which it is not far
  BoardViews again = views;
  const double kept = median(fit.rms_px);
  const double fitted = median(fit_near(again, surface_, existing_.model.camera, false).rms_px);
  const std::string value = "corners miss it by " + figure(kept, " px") +
                            " (RMS, median of the views), a camera fitted to these views by " +
                            figure(fitted, " px");
  if (kept > kMinded && kept > kFarBetter * fitted) {
    throw UnusableInput("camera of " + existing_.file, value,
                        "its lens or focus was changed: calibrate the camera too");
  }
  note_ = "camera and flange_to_camera are kept from " + existing_.file + ": " + value;
}

HandEye KnownCamera::hand_eye(const PosePairs& pairs) {
  constexpr double kMinded = 3e-4;                   // [m]
  constexpr double kMindedAngle = 0.1 * M_PI / 180;  // [rad]
  const Eigen::Isometry3d half_turn = surface_.half_turn();
  const HandEye free = fit_hand_eye(pairs.flange, pairs.board, half_turn);
  if (agree(free, pairs.flange.size())) check_board_size(free, pairs, board_.square_size);
  const HandEye kept =
      fit_board(existing_.model.flange_to_camera, pairs.flange, pairs.board, half_turn);
  const bool fits = agree(kept, pairs.flange.size());
  if (!fits) agreed_hand_eye(pairs, surface_);  // says what else may be wrong with the poses
  const Scatter by_kept(kept), by_free(free);
  const auto far = [](double one, double other, double minded) {
    return one > minded && one > kFarBetter * other;
  };
  const std::string fitted = ", a pose fitted to these views by " + by_free.text();
  if (!fits || far(by_kept.position, by_free.position, kMinded) ||
      far(by_kept.angle, by_free.angle, kMindedAngle)) {
    throw UnusableInput("flange_to_camera of " + existing_.file,
                        fits ? "scatters the board by " + by_kept.text() + " between views" + fitted
                             : share(kept.count, pairs.flange.size()) + " views fit it",
                        "the camera was moved on the flange: calibrate it too");
  }
  note_ += "; it scatters the board by " + by_kept.text() + " between views" + fitted;
  return kept;
}

}  // namespace scan_calibration
