// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "search/guesses.h"

namespace tool_path_stretcher {
namespace {

/// The bounding box of points in a frame rotated by `axes` (its columns).
Eigen::AlignedBox3d extent_along(const Eigen::Matrix3d& axes, const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(Eigen::Vector3d(axes.transpose() * point));
  return box;
}

/// The axes along which the points fill the smallest rectangle, seen along the last axis. Unlike
/// principal axes, they stay along a plate's edges if a part of the plate is missing.
Eigen::Matrix3d rectangle_axes(const CoarseSurface& surface) {
  constexpr int kSteps = 60;  // of a right angle
  Eigen::Matrix3d best = surface.frame.axes;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::AngleAxisd turn(i * M_PI_2 / kSteps, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d turned = surface.frame.axes * turn.toRotationMatrix();
    const Eigen::Vector3d sizes = extent_along(turned, surface.queries).sizes();
    if (sizes.x() * sizes.y() >= least) continue;
    least = sizes.x() * sizes.y();
    best = turned;
  }
  return best;
}

/// The axes along which the normals spread: perpendicular to the faces of a boxy part, whatever
/// share of each face is missing.
Eigen::Matrix3d normal_axes(const CoarseSurface& surface) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& normal : surface.normals)
    spread += normal * normal.transpose();
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return axes;
}

/// An interval on one axis.
struct Stretch {
  double from;
  double to;
  double middle() const { return (from + to) / 2; }
  double length() const { return to - from; }
};

/// Possible middles of an interval of some length: at the other's middle, or with ends aligned.
std::vector<double> inside(const Stretch& other, double length) {
  constexpr double kAlike = 0.1;
  if (std::abs(other.length() - length) < kAlike * other.length()) return {other.middle()};
  return {other.from + length / 2, other.middle(), other.to - length / 2};
}

/// The same with a quarter or half of it beyond either end.
std::vector<double> half_out(const Stretch& other, double length) {
  return {other.from, other.from + length / 4, other.to - length / 4, other.to};
}

/// All placements of the rotated and scaled reference around the object's box.
class Places {
 public:
  Places(const Eigen::Matrix3d& axes, const Eigen::AlignedBox3d& object_box,
         const Eigen::AlignedBox3d& turned_box, const Eigen::Matrix3d& rotation, double scale)
      : axes_(axes), rotation_(rotation), scale_(scale), centre_(scale * turned_box.center()) {
    for (int axis = 0; axis < 3; ++axis) {
      const Stretch stretch{object_box.min()[axis], object_box.max()[axis]};
      const double length = scale * turned_box.sizes()[axis];
      inside_[static_cast<std::size_t>(axis)] = inside(stretch, length);
      out_[static_cast<std::size_t>(axis)] = half_out(stretch, length);
    }
  }

  void add_to(std::vector<Similarity>& guesses) const {
    add(inside_, guesses);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<std::vector<double>, 3> places = inside_;
      places[axis] = out_[axis];
      add(places, guesses);
    }
  }

 private:
  void add(const std::array<std::vector<double>, 3>& places,
           std::vector<Similarity>& guesses) const {
    for (const double x : places[0]) {
      for (const double y : places[1]) {
        for (const double z : places[2])
          guesses.push_back({scale_, rotation_, axes_ * (Eigen::Vector3d(x, y, z) - centre_)});
      }
    }
  }

  Eigen::Matrix3d axes_;
  Eigen::Matrix3d rotation_;
  double scale_;
  Eigen::Vector3d centre_;
  std::array<std::vector<double>, 3> inside_;
  std::array<std::vector<double>, 3> out_;
};

/// Adds the reference's axes laid along the object's in all rotations of a cube, sized by each
/// axis.
void add_turns(const CoarseSurface& reference, const Eigen::Matrix3d& reference_axes,
               const CoarseSurface& object, const Eigen::Matrix3d& object_axes,
               std::vector<Similarity>& guesses) {
  constexpr double kThin = 0.05;  // of the longest axis: too short to tell the size
  const Eigen::AlignedBox3d object_box = extent_along(object_axes, object.queries);
  for (const Eigen::Matrix3d& turn : cube_turns()) {
    const Eigen::Matrix3d rotation = object_axes * turn * reference_axes.transpose();
    const Eigen::AlignedBox3d turned_box =
        extent_along(rotation.transpose() * object_axes, reference.queries);
    for (int axis = 0; axis < 3; ++axis) {
      if (turned_box.sizes()[axis] < kThin * turned_box.sizes().maxCoeff()) continue;
      const double scale = object_box.sizes()[axis] / turned_box.sizes()[axis];
      Places(object_axes, object_box, turned_box, rotation, scale).add_to(guesses);
    }
  }
}

}  // namespace

std::vector<Similarity> overlapping_guesses(const CoarsePair& surfaces) {
  const auto& [reference, object] = surfaces;
  std::vector<Similarity> guesses;
  add_turns(reference, reference.frame.axes, object, object.frame.axes, guesses);
  add_turns(reference, rectangle_axes(reference), object, rectangle_axes(object), guesses);
  add_turns(reference, normal_axes(reference), object, normal_axes(object), guesses);
  return guesses;
}

}  // namespace tool_path_stretcher
