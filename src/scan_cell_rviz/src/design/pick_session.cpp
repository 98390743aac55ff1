// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "design/pick_session.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scan_cell_rviz {
namespace {

using Eigen::Vector3d;

Vector3d position(const geometry_msgs::Point& point) {
  return {point.x, point.y, point.z};
}

/// Distance along the ray to a triangle (Moeller and Trumbore 1997); infinity: no intersection.
double met_at(const Ray& ray, const Vector3d& corner, const Vector3d& one, const Vector3d& other) {
  constexpr double kNowhere = std::numeric_limits<double>::infinity();
  const Vector3d across = ray.direction.cross(other);
  const double volume = one.dot(across);
  if (volume == 0) return kNowhere;
  const Vector3d off = ray.origin - corner;
  const double u = off.dot(across) / volume;
  if (!(u >= 0 && u <= 1)) return kNowhere;
  const Vector3d about = off.cross(one);
  const double v = ray.direction.dot(about) / volume;
  if (!(v >= 0 && u + v <= 1)) return kNowhere;
  const double along = other.dot(about) / volume;
  return along > 0 ? along : kNowhere;
}

}  // namespace

std::optional<Vector3d> first_hit(const std::vector<geometry_msgs::Point>& corners,
                                  const Ray& ray) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vector3d corner = position(corners[i]);
    least = std::min(least, met_at(ray, corner, position(corners[i + 1]) - corner,
                                   position(corners[i + 2]) - corner));
  }
  if (!std::isfinite(least)) return std::nullopt;
  return ray.origin + least * ray.direction;
}

void PickSession::open(const visualization_msgs::MarkerConstPtr& reference) {
  reference_ = reference;
}

void PickSession::close() {
  reference_.reset();
  clear();
}

Eigen::AlignedBox3d PickSession::box() const {
  Eigen::AlignedBox3d box;
  if (!is_open()) return box;
  for (const geometry_msgs::Point& corner : reference_->points)
    box.extend(position(corner));
  return box;
}

bool PickSession::pick(const Ray& ray) {
  const auto place = is_open() ? first_hit(reference_->points, ray) : std::nullopt;
  if (!place) return false;
  picks_.push_back(*place);
  undone_.clear();
  Q_EMIT changed();
  return true;
}

void PickSession::undo() {
  if (picks_.empty()) return;
  undone_.push_back(picks_.back());
  picks_.pop_back();
  Q_EMIT changed();
}

void PickSession::redo() {
  if (undone_.empty()) return;
  picks_.push_back(undone_.back());
  undone_.pop_back();
  Q_EMIT changed();
}

void PickSession::clear() {
  picks_.clear();
  undone_.clear();
  Q_EMIT changed();
}

PickSession& shared_pick_session() {
  static PickSession session;
  return session;
}

}  // namespace scan_cell_rviz
