// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "estimate/camera_fit.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "geometry/statistics.h"
#include "scan_cell_common/errors.h"

namespace scan_calibration {
namespace {

using scan_cell_common::UnusableInput;

std::vector<cv::Point3f> places_of(const BoardView& view) {
  std::vector<cv::Point3f> points;
  for (const Eigen::Vector2d& place : view.places)
    points.emplace_back(static_cast<float>(place.x()), static_cast<float>(place.y()), 0.f);
  return points;
}

std::vector<cv::Point2f> pixels_of(const BoardView& view) {
  std::vector<cv::Point2f> points;
  for (const Eigen::Vector2d& pixel : view.pixels)
    points.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  return points;
}

/// Focal lengths to start from: Zhang's, then some that lenses have.
std::vector<double> focal_lengths(const BoardViews& views, int width, int height) {
  std::vector<std::vector<cv::Point3f>> places;
  std::vector<std::vector<cv::Point2f>> pixels;
  for (const BoardView& view : views) {
    places.push_back(places_of(view));
    pixels.push_back(pixels_of(view));
  }
  const int size = std::max(width, height);
  std::vector<double> result;
  try {
    const cv::Mat matrix = cv::initCameraMatrix2D(places, pixels, cv::Size(width, height), 1);
    const double zhang = matrix.at<double>(0, 0);
    if (zhang > 0.2 * size && zhang < 20 * size) result.push_back(zhang);
  } catch (const cv::Exception&) {
    // Views that determine none: the fit from the others tells
  }
  for (const double focal : {1., 2., 0.5, 4., 8.})
    result.push_back(focal * size);
  return result;
}

Eigen::Isometry3d board_pose(const BoardView& view, const CameraVector& camera) {
  const cv::Matx33d matrix(camera[0], 0, camera[2], 0, camera[1], camera[3], 0, 0, 1);
  const cv::Vec<double, 5> distortion(camera[4], camera[5], camera[6], camera[7], camera[8]);
  cv::Vec3d turn, shift;
  if (!cv::solvePnP(places_of(view), pixels_of(view), matrix, distortion, turn, shift, false,
                    cv::SOLVEPNP_IPPE)) {
    throw UnusableInput("view " + view.name, "its corners fit no pose",
                        "check the order of the corners");
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d axis(turn[0], turn[1], turn[2]);
  if (axis.norm() > 0)
    pose.linear() = Eigen::AngleAxisd(axis.norm(), axis.normalized()).toRotationMatrix();
  pose.translation() << shift[0], shift[1], shift[2];
  return pose;
}

/// A camera alone is a scanner whose measured poses are where the board has the camera, and free.
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
      view.measured = board_pose(view, state_.camera).inverse();
  }

  void solve(FitChoice choice) {
    choice.robot = false;
    fit(views_, surface_, noise_, choice, state_);
  }

  /// Solves with what misses weighted less.
  void solve_robustly(const FitChoice& choice) {
    constexpr int kReweighings = 3;
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
    constexpr double kRayleigh = 1.17741;  // median of the length of a vector of unit noise
    std::vector<double> lengths;
    for (std::size_t i = 0; i < views_.size(); ++i)
      for (const Eigen::Vector2d& residual : residuals(i))
        lengths.push_back(residual.norm());
    constexpr double kLeast = 1e-4;  // [px]
    noise_.corner_px = std::max(median(lengths) / kRayleigh, kLeast);
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
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    squares += residuals[i].squaredNorm();
    count += 1;
  }
  return std::sqrt(squares / count);
}

CameraFit fit_camera(BoardViews& views, const BoardSurface& surface, int width, int height,
                     bool square_pixels, bool robust) {
  constexpr double kGood = 2;         // [px] of the median view: no need to look for a better start
  constexpr double kMostMiss = 0.01;  // of the image's width: this is not that board
  FitChoice choice;
  choice.square_pixels = square_pixels;
  BoardViews scratch = views;
  double least = std::numeric_limits<double>::infinity();
  CameraFit best;
  for (const double focal : focal_lengths(views, width, height)) {
    BoardViews trial = views;
    CameraFit found;
    try {
      FreePoses poses(trial, surface,
                      {width, height, focal, focal, (width - 1) / 2., (height - 1) / 2.});
      poses.solve(choice);
      if (robust) poses.solve_robustly(choice);
      found = poses.result();
    } catch (const UnusableInput&) {
      continue;  // no camera is near this start: there are others
    } catch (const cv::Exception&) {
      continue;  // no pose from these corners
    }
    const double typical = median(found.rms_px);
    if (typical < least) {
      least = typical;
      best = found;
      scratch = trial;
    }
    if (least < kGood) break;
  }
  if (!(least < kMostMiss * width)) {
    throw UnusableInput(
        "corners of the board",
        best.rms_px.empty() ? "fit no camera" : "miss any camera by " + figure(least, " px"),
        "check the board's columns and rows, and that the corners are named row by row");
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
