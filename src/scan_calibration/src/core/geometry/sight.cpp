// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/sight.h"

#include <ceres/jet.h>
#include <ceres/rotation.h>

#include <Eigen/LU>

namespace scan_calibration {
namespace {

using Jet = ceres::Jet<double, 18>;

template <typename T>
struct Rigid {
  Eigen::Matrix<T, 3, 3> rotation;
  Eigen::Matrix<T, 3, 1> translation;

  Rigid operator*(const Rigid& other) const {
    return {rotation * other.rotation, rotation * other.translation + translation};
  }
  Rigid inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
};

Rigid<Jet> moved(const Eigen::Isometry3d& pose, const Vector6d& motion, int first) {
  Eigen::Matrix<Jet, 6, 1> jets;
  for (int i = 0; i < 6; ++i)
    jets[i] = Jet(motion[i], first + i);
  Rigid<Jet> step;
  ceres::AngleAxisToRotationMatrix(jets.data() + 3, step.rotation.data());
  step.translation = jets.head<3>();
  return Rigid<Jet>{pose.linear().cast<Jet>(), pose.translation().cast<Jet>()} * step;
}

/// Radial and tangential distortion (Brown 1966) of a ray.
struct Distortion {
  Eigen::Vector2d place;
  Eigen::Matrix2d by_ray;
  Eigen::Matrix<double, 2, 5> by_coefficients;
};

Distortion distort(const CameraVector& camera, double x, double y) {
  const double k1 = camera[4], k2 = camera[5], p1 = camera[6], p2 = camera[7], k3 = camera[8];
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
  const double slope = 2 * (k1 + r2 * (2 * k2 + r2 * 3 * k3));  // of radial: by x this times x
  Distortion result;
  result.place << x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
      y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y;
  const double mixed = x * y * slope + 2 * p1 * x + 2 * p2 * y;
  result.by_ray << radial + x * x * slope + 2 * p1 * y + 6 * p2 * x, mixed,  //
      mixed, radial + y * y * slope + 6 * p1 * y + 2 * p2 * x;
  result.by_coefficients << x * r2, x * r2 * r2, 2 * x * y, r2 + 2 * x * x, x * r2 * r2 * r2,  //
      y * r2, y * r2 * r2, r2 + 2 * y * y, 2 * x * y, y * r2 * r2 * r2;
  return result;
}

/// Depth at which a ray from the lens meets the board, in a few Newton steps.
/// @return false if it does not meet the board in front of the camera
bool meet(const BoardSurface& surface, const Eigen::Vector3d& bend, const Eigen::Vector3d& start,
          const Eigen::Vector3d& direction, double& depth) {
  constexpr int kSteps = 4;  // chosen: a board is bent by a few mm, each step squares the error
  depth = -start.z() / direction.z();
  for (int step = 0; step < kSteps && !bend.isZero(0); ++step) {
    const Eigen::Vector3d point = start + depth * direction;
    const Eigen::Vector2d slope = surface.slope(point.head<2>()) * bend;
    const double miss = point.z() - surface.basis(point.head<2>()).dot(bend);
    depth -= miss / (direction.z() - slope.dot(direction.head<2>()));
  }
  return std::isfinite(depth) && depth > 0;
}

}  // namespace

BoardSight board_sight(const Eigen::Isometry3d& flange_to_camera,
                       const Eigen::Isometry3d& base_to_board,
                       const Eigen::Isometry3d& base_to_flange, const Vector6d& camera_motion,
                       const Vector6d& board_motion, const Vector6d& flange_motion) {
  const Rigid<Jet> camera =
      moved(base_to_flange, flange_motion, 12) * moved(flange_to_camera, camera_motion, 0);
  const Rigid<Jet> board = camera.inverse() * moved(base_to_board, board_motion, 6);
  BoardSight sight;
  for (int row = 0; row < 3; ++row) {
    sight.position[row] = board.translation[row].a;
    sight.by_motions.row(3 + row) = board.translation[row].v;
    for (int column = 0; column < 3; ++column)
      sight.rotation(row, column) = board.rotation(row, column).a;
  }
  for (int i = 0; i < 18; ++i) {
    Eigen::Matrix3d change;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        change(row, column) = board.rotation(row, column).v[i];
    const Eigen::Matrix3d turn = change * sight.rotation.transpose();
    sight.by_motions.col(i).head<3>() << (turn(2, 1) - turn(1, 2)) / 2,
        (turn(0, 2) - turn(2, 0)) / 2, (turn(1, 0) - turn(0, 1)) / 2;
  }
  return sight;
}

BoardSight board_sight(const Eigen::Isometry3d& camera_to_board) {
  BoardSight sight;
  sight.rotation = camera_to_board.linear();
  sight.position = camera_to_board.translation();
  sight.by_motions.setZero();
  return sight;
}

bool project(const CameraVector& camera, const Eigen::Vector3d& point, Projection& result) {
  constexpr double kMinDepth = 1e-6;  // [m] chosen
  if (!(point.z() > kMinDepth)) return false;
  const double x = point.x() / point.z();
  const double y = point.y() / point.z();
  const Distortion lens = distort(camera, x, y);
  const Eigen::Vector2d focal = camera.head<2>();
  result.pixel = focal.cwiseProduct(lens.place) + camera.segment<2>(2);
  Eigen::Matrix<double, 2, 3> ray;
  ray << 1, 0, -x, 0, 1, -y;
  result.by_point = focal.asDiagonal() * lens.by_ray * (ray / point.z());
  result.by_camera.leftCols<2>() = lens.place.asDiagonal();
  result.by_camera.middleCols<2>(2).setIdentity();
  result.by_camera.rightCols<5>() = focal.asDiagonal() * lens.by_coefficients;
  return true;
}

bool line_offset(const ScannerState& scanner, const BoardSurface& surface, const BoardSight& sight,
                 const Eigen::Vector2d& pixel, const Eigen::Vector3d& plane, LineOffset& result) {
  const std::optional<Eigen::Vector3d> seen = ray_of(scanner.intrinsics(), pixel);
  if (!seen) return false;
  const Eigen::Vector3d& ray = *seen;
  double depth = 0;
  if (!meet(surface, scanner.bend, -(sight.rotation.transpose() * sight.position),
            sight.rotation.transpose() * ray, depth)) {
    return false;
  }
  result.point = depth * ray;
  result.value = plane.dot(result.point) - 1;

  const Eigen::Vector3d lever = result.point - sight.position;
  const Eigen::Vector2d place = (sight.rotation.transpose() * lever).head<2>();
  const Eigen::Vector2d slope = surface.slope(place) * scanner.bend;
  const Eigen::Vector3d normal = sight.rotation * Eigen::Vector3d(-slope.x(), -slope.y(), 1);
  const Eigen::Vector3d by_shift = plane.dot(ray) / normal.dot(ray) * normal;
  result.by_sight << lever.cross(by_shift), by_shift;
  result.by_bend = plane.dot(ray) / normal.dot(ray) * surface.basis(place);

  const Eigen::Vector2d focal = scanner.camera.head<2>();
  const Eigen::Vector2d distorted = (pixel - scanner.camera.segment<2>(2)).cwiseQuotient(focal);
  const Distortion lens = distort(scanner.camera, ray.x(), ray.y());
  const Eigen::RowVector2d by_distorted =
      (depth * (plane - by_shift)).head<2>().transpose() * lens.by_ray.inverse();
  result.by_pixel = by_distorted.transpose().cwiseQuotient(focal);
  result.by_camera.head<2>() = -result.by_pixel.cwiseProduct(distorted);
  result.by_camera.segment<2>(2) = -result.by_pixel;
  result.by_camera.tail<5>() = -(by_distorted * lens.by_coefficients).transpose();
  return result.by_pixel.allFinite() && result.by_pixel.norm() > 0;
}

Eigen::Vector3d on_board(const BoardSurface& surface, const Eigen::Vector3d& bend,
                         const Eigen::Vector2d& place) {
  return {place.x(), place.y(), surface.basis(place).dot(bend)};
}

}  // namespace scan_calibration
