// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/camera_fit.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <optional>

#include "geometry/opencv.h"
#include "geometry/statistics.h"
#include "scan_cell_common/errors/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

BoardPoints points_of(const BoardView& view) {
  BoardPoints points;
  for (std::size_t i = 0; i < view.places.size(); ++i)
    points.add(view.places[i], view.pixels[i]);
  return points;
}

/// Focal lengths [px] to start from: Zhang's, then common ones.
std::vector<double> focal_lengths(const BoardViews& views, int width, int height) {
  std::vector<BoardPoints> seen;
  std::transform(views.begin(), views.end(), std::back_inserter(seen), points_of);
  const BoardPointLists points(seen);
  constexpr double kMin = 0.2, kMax = 20;  // of the longer side, chosen: fisheye to telephoto
  const int size = std::max(width, height);
  std::vector<double> result;
  try {
    const cv::Mat matrix = cv::initCameraMatrix2D(points.places, points.pixels, {width, height}, 1);
    const double zhang = matrix.at<double>(0, 0);
    if (zhang > kMin * size && zhang < kMax * size) result.push_back(zhang);
  } catch (const cv::Exception&) {
    // The views determine none: the other focal lengths have to do
  }
  for (const double focal : {1., 2., 0.5, 4., 8.})
    result.push_back(focal * size);
  return result;
}

Eigen::Isometry3d board_pose(const BoardView& view,
                             const scan_cell_common::CameraIntrinsics& camera) {
  const BoardPoints points = points_of(view);
  cv::Vec3d rotation, translation;
  if (!cv::solvePnP(points.places, points.pixels, camera_matrix(camera), distortion(camera),
                    rotation, translation, false, cv::SOLVEPNP_IPPE)) {
    throw UnusableInput("view " + view.name, "no pose fits its corners",
                        "check the order of the corners");
  }
  return pose_of(rotation, translation);
}

/// A camera alone: a scanner whose measured poses put the camera where the board has it, and are
/// free.
class FreePoses {
 public:
  FreePoses(BoardViews& views, const BoardSurface& surface,
            const scan_cell_common::CameraIntrinsics& camera)
      : views_(views), surface_(surface) {
    state_.width = camera.width;
    state_.height = camera.height;
    state_.camera = camera_vector(camera);
    state_.corrections.assign(views.size(), Vector6d::Zero());
    constexpr double kFree = std::numeric_limits<double>::infinity();
    noise_ = {1, {}, kFree, kFree};
    for (BoardView& view : views)
      view.measured = board_pose(view, camera).inverse();
  }

  void solve(FitChoice choice) {
    choice.robot = false;
    fit(views_, surface_, noise_, choice, state_);
  }

  /// Solves with less weight on outliers.
  void solve_robustly(const FitChoice& choice) {
    constexpr int kReweighings = 3;  // chosen: the joint estimate goes on from there
    for (int i = 0; i < kReweighings; ++i) {
      reweigh();
      solve(choice);
    }
  }

  CameraFit result() const {
    CameraFit result{state_, {}, {}, noise_.corner_px};
    for (std::size_t i = 0; i < views_.size(); ++i) {
      result.camera_to_board.push_back(moved(views_[i].measured, state_.corrections[i]).inverse());
      result.rms_px.push_back(rms_of(residuals(i), views_[i].weights));
    }
    return result;
  }

 private:
  void reweigh() {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < views_.size(); ++i)
      for (const Eigen::Vector2d& residual : residuals(i))
        lengths.push_back(residual.norm());
    constexpr double kMinDeviation = 1e-4;  // [px] chosen: rounding
    noise_.corner_px = std::max(median(lengths) / kMedianLength2, kMinDeviation);
    weigh(state_, surface_, noise_, Multiplicities{}, views_);
  }

  std::vector<Eigen::Vector2d> residuals(std::size_t i) const {
    return corner_residuals(state_, surface_, sight_of(state_, views_[i], i), views_[i]);
  }

  BoardViews& views_;
  const BoardSurface& surface_;
  ScannerState state_;
  NoiseLevels noise_;
};

}  // namespace

double rms_of(const std::vector<Eigen::Vector2d>& residuals, const std::vector<double>& weights) {
  SquareSum sum;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (weights[i] > 0) sum.add(residuals[i].squaredNorm());
  return sum.rms();
}

namespace {

/// A fit from a start; none if these corners give no camera near it.
std::optional<CameraFit> fit_from(const scan_cell_common::CameraIntrinsics& start,
                                  const FitChoice& choice, bool robust, const BoardSurface& surface,
                                  BoardViews& views) {
  try {
    FreePoses poses(views, surface, start);
    poses.solve(choice);
    if (robust) poses.solve_robustly(choice);
    return poses.result();
  } catch (const UnusableInput&) {  // no camera near this start
  } catch (const cv::Exception&) {  // these corners give no pose
  }
  return std::nullopt;
}

}  // namespace

CameraFit fit_camera(BoardViews& views, const BoardSurface& surface, int width, int height,
                     bool square_pixels, bool robust) {
  constexpr double kGood = 2;        // [px] of the median view, chosen: no better start is needed
  constexpr double kMaxMiss = 0.01;  // of the image's width, chosen: it is another board
  FitChoice choice;
  choice.square_pixels = square_pixels;
  BoardViews scratch = views;
  double least = std::numeric_limits<double>::infinity();
  CameraFit best;
  for (const double focal : focal_lengths(views, width, height)) {
    BoardViews trial = views;
    const std::optional<CameraFit> found =
        fit_from({width, height, focal, focal, (width - 1) / 2., (height - 1) / 2.}, choice, robust,
                 surface, trial);
    if (!found) continue;
    const double typical = median(found->rms_px);
    if (typical < least) {
      least = typical;
      best = *found;
      scratch = trial;
    }
    if (least < kGood) break;
  }
  if (!(least < kMaxMiss * width)) {
    throw UnusableInput(
        "corners of the board",
        best.rms_px.empty() ? "fit no camera" : "miss the best camera by " + figure(least, " px"),
        "check the board's columns and rows, and that the corners are listed row by row");
  }
  for (std::size_t i = 0; i < views.size(); ++i)
    views[i].weights = scratch[i].weights;
  return best;
}

CameraFit fit_near(BoardViews& views, const BoardSurface& surface,
                   const scan_cell_common::CameraIntrinsics& camera, bool keep) {
  FitChoice choice;
  choice.camera = !keep;
  FreePoses poses(views, surface, camera);
  poses.solve(choice);
  poses.solve_robustly(choice);
  return poses.result();
}

}  // namespace scan_calibration
