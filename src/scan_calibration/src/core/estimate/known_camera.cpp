// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/known_camera.h"

#include <fmt/core.h>

#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kFarBetter = 3;  // ratio of the misfits, chosen

/// Robust standard deviation of the board along an axis, over the views that fit.
struct Scatter {
  explicit Scatter(const HandEye& found) {
    std::vector<double> offsets, angles;
    for (std::size_t i = 0; i < found.fits.size(); ++i) {
      if (!found.fits[i]) continue;
      offsets.push_back(found.offset[i]);
      angles.push_back(found.angle[i]);
    }
    position = median(offsets) / kMedianLength3;
    angle = median(angles) / kMedianLength3;
  }

  std::string text() const { return millimetres(position) + " and " + degrees(angle); }

  double position = 0;  // [m]
  double angle = 0;     // [rad]
};

}  // namespace

KnownCamera::KnownCamera(const ExistingScanner& existing, const Observations& observations)
    : existing_(existing), board_(observations.board), surface_(observations.board) {
  const scan_cell_common::CameraIntrinsics& camera = existing.model.camera;
  if (camera.width == observations.width && camera.height == observations.height) return;
  throw UnusableInput("camera of " + existing.file,
                      fmt::format("{} x {} pixels; the images have {} x {}", camera.width,
                                  camera.height, observations.width, observations.height),
                      "it is another camera: calibrate it too");
}

CameraFit KnownCamera::fit(BoardViews& views) const {
  return fit_near(views, surface_, existing_.model.camera, true);
}

void KnownCamera::check_lens(const BoardViews& views, const CameraFit& fit) {
  constexpr double kMinMisfit = 0.3;  // [px] chosen: less is not worth a refusal
  BoardViews again = views;
  const double kept = median(fit.rms_px);
  const double fitted = median(fit_near(again, surface_, existing_.model.camera, false).rms_px);
  const std::string value = fmt::format(
      "corners miss it by {} (RMS, median of the views), a camera fitted to these views by {}",
      figure(kept, " px"), figure(fitted, " px"));
  if (kept > kMinMisfit && kept > kFarBetter * fitted) {
    throw UnusableInput("camera of " + existing_.file, value,
                        "its lens or focus has changed: calibrate the camera too");
  }
  note_ = "camera and flange_to_camera are kept from " + existing_.file + ": " + value;
}

HandEye KnownCamera::hand_eye(const PosePairs& pairs) {
  constexpr double kMinScatter = 3e-4;        // [m] chosen: less is not worth a refusal
  constexpr double kMinTurn = 0.1 * kDegree;  // [rad] chosen: the same
  const Eigen::Isometry3d half_turn = surface_.half_turn();
  const HandEye free = fit_hand_eye(pairs.flange, pairs.board, half_turn);
  if (agree(free, pairs.flange.size())) check_board_size(free, pairs, board_.square_size);
  const HandEye kept =
      fit_board(existing_.model.flange_to_camera, pairs.flange, pairs.board, half_turn);
  const bool fits = agree(kept, pairs.flange.size());
  if (!fits) agreed_hand_eye(pairs, surface_);  // finds what else is wrong with the poses
  const Scatter by_kept(kept), by_free(free);
  const auto far = [](double one, double other, double min) {
    return one > min && one > kFarBetter * other;
  };
  const std::string fitted = ", a pose fitted to these views by " + by_free.text();
  if (!fits || far(by_kept.position, by_free.position, kMinScatter) ||
      far(by_kept.angle, by_free.angle, kMinTurn)) {
    throw UnusableInput("flange_to_camera of " + existing_.file,
                        fits ? "scatters the board by " + by_kept.text() + " between views" + fitted
                             : share(kept.count, pairs.flange.size()) + " views fit it",
                        "the camera has moved on the flange: calibrate it too");
  }
  note_ += "; it scatters the board by " + by_kept.text() + " between views" + fitted;
  return kept;
}

}  // namespace scan_calibration
