// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/scanner_state.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace scan_calibration {
namespace {

/// A point of the plane: the known projector projected onto it, or else its nearest point beside
/// the lens.
Eigen::Vector3d origin_of(const scan_cell_common::LaserPlane& plane,
                          const std::vector<Eigen::Vector3d>& projectors, std::size_t laser) {
  if (laser < projectors.size()) {
    const Eigen::Vector3d& known = projectors[laser];
    return known - (plane.normal.dot(known) - plane.distance) * plane.normal;
  }
  constexpr double kMinSideways = 0.1;  // of the normal, chosen: else the plane crosses the view
  const Eigen::Vector3d beside(plane.normal.x(), plane.normal.y(), 0);
  if (beside.norm() < kMinSideways) return plane.distance * plane.normal;
  return plane.distance / beside.squaredNorm() * beside;
}

/// Mean of x^2 over `count` places evenly from -1 to 1.
double mean_square(int count) {
  return (count + 1.0) / (3.0 * (count - 1.0));
}

}  // namespace

scan_cell_common::CameraIntrinsics ScannerState::intrinsics() const {
  scan_cell_common::CameraIntrinsics result;
  result.width = width;
  result.height = height;
  result.fx = camera[0];
  result.fy = camera[1];
  result.cx = camera[2];
  result.cy = camera[3];
  result.distortion = camera.tail<5>();
  return result;
}

CameraVector camera_vector(const scan_cell_common::CameraIntrinsics& camera) {
  CameraVector result;
  result << camera.fx, camera.fy, camera.cx, camera.cy, camera.distortion;
  return result;
}

Eigen::Isometry3d moved(const Eigen::Isometry3d& pose, const Vector6d& motion) {
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d turn = motion.tail<3>();
  step.translation() = motion.head<3>();
  if (turn.norm() > 0)
    step.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  Eigen::Isometry3d result = pose * step;
  result.linear() = nearest_rotation(result.linear());
  return result;
}

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(Eigen::Quaterniond(rotation).normalized());
  return turn.angle() * turn.axis();
}

double angle_of(const Eigen::Matrix3d& rotation) {
  return rotation_vector(rotation).norm();
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

scan_cell_common::ScannerModel scanner_model(const ScannerState& state,
                                             const std::vector<std::string>& lasers,
                                             const std::vector<Eigen::Vector3d>& projectors) {
  scan_cell_common::ScannerModel model;
  model.camera = state.intrinsics();
  model.flange_to_camera = state.flange_to_camera;
  for (std::size_t laser = 0; laser < state.planes.size(); ++laser) {
    scan_cell_common::LaserPlane plane;
    plane.distance = -1 / state.planes[laser].norm();
    plane.normal = state.planes[laser] * plane.distance;
    plane.origin = origin_of(plane, projectors, laser);
    const std::size_t index = scan_cell_common::laser_index(lasers[laser]);
    model.lasers.resize(std::max(model.lasers.size(), index + 1));
    model.lasers[index] = plane;
  }
  return model;
}

BoardSurface::BoardSurface(const Board& board)
    : centre_(Eigen::Vector2d(board.columns - 1, board.rows - 1) * board.square_size / 2),
      half_(centre_),
      mean_squares_(mean_square(board.columns), mean_square(board.rows)) {}

Eigen::Vector3d BoardSurface::basis(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d unit = unit_place(place);
  return {unit.x() * unit.x() - mean_squares_.x(), unit.x() * unit.y(),
          unit.y() * unit.y() - mean_squares_.y()};
}

Eigen::Matrix<double, 2, 3> BoardSurface::slope(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d unit = unit_place(place);
  const double per_x = std::abs(unit.x()) < 1 ? 1 / half_.x() : 0;
  const double per_y = std::abs(unit.y()) < 1 ? 1 / half_.y() : 0;
  Eigen::Matrix<double, 2, 3> result;
  result << 2 * unit.x() * per_x, unit.y() * per_x, 0,  //
      0, unit.x() * per_y, 2 * unit.y() * per_y;
  return result;
}

Eigen::Vector2d BoardSurface::unit_place(const Eigen::Vector2d& place) const {
  return (place - centre_).cwiseQuotient(half_).cwiseMax(-1).cwiseMin(1);
}

Eigen::Isometry3d BoardSurface::half_turn() const {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  turn.translation() << 2 * centre_.x(), 2 * centre_.y(), 0;
  return turn;
}

}  // namespace scan_calibration
