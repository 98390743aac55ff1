// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_reader/gcode_axes.h"

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/euler_angles.h"
#include "scan_cell_common/pose/units.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::kDegrees;
constexpr double kUpright = 1e-9;  // sine of the spindle's tilt below which C is arbitrary

const scan_cell_common::EulerSequence& yaw_pitch_roll() {
  static const scan_cell_common::EulerSequence sequence("zyx");
  return sequence;
}

Eigen::Matrix3d turned(const Eigen::Vector3d& degrees, const std::string& dialect) {
  const Eigen::Vector3d angles = degrees / kDegrees;
  const Eigen::AngleAxisd about_z(angles.z(), Eigen::Vector3d::UnitZ());
  if (dialect == "xyzac")
    return (about_z * Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX())).toRotationMatrix();
  if (dialect == "xyzbc")
    return (about_z * Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY())).toRotationMatrix();
  return Eigen::Matrix3d::Identity();
}

/// Rotation from the spindle's frame, z up, to the tool's, z into the part.
Eigen::Matrix3d into_part() {
  return Eigen::Vector3d(1, -1, -1).asDiagonal();
}

/// The same angle [degrees], shifted by whole turns to be nearest to another.
double near(double angle, double to) {
  return std::isfinite(to) ? angle + 360 * std::round((to - angle) / 360) : angle;
}

double way(const Eigen::Vector3d& angles, const GcodeAxes& before) {
  double sum = 0;
  for (Eigen::Index i = 0; i < 3; ++i)
    sum += std::isfinite(before[i + 3]) ? std::abs(angles[i] - before[i + 3]) : 0;
  return sum;
}

}  // namespace

GcodeDialect::GcodeDialect(const std::string& name) : name_(name.empty() ? "xyzabc" : name) {
  if (name_ != "xyzabc" && name_ != "xyzac" && name_ != "xyzbc" && name_ != "xyz")
    throw scan_cell_common::InvalidParameter("dialect", name,
                                             "give one of xyzabc, xyzac, xyzbc, xyz");
  const std::string letters = "xyzabc";
  for (const char letter : name_)
    axes_.push_back(static_cast<Eigen::Index>(letters.find(letter)));
}

bool GcodeDialect::has(Eigen::Index axis) const {
  return std::find(axes_.begin(), axes_.end(), axis) != axes_.end();
}

Eigen::Isometry3d GcodeDialect::pose(const GcodeAxes& axes) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = 1e-3 * axes.head<3>();
  const Eigen::Vector3d angles = axes.tail<3>();
  pose.linear() = says_orientations() ? yaw_pitch_roll().rotation(angles.reverse() / kDegrees)
                                      : Eigen::Matrix3d(turned(angles, name_) * into_part());
  return pose;
}

/// All A B C [degrees] for a rotation, up to whole turns.
std::vector<Eigen::Vector3d> GcodeDialect::solutions(const Eigen::Matrix3d& rotation,
                                                     const GcodeAxes& before) const {
  if (name_ == "xyz") return {Eigen::Vector3d::Zero()};
  if (says_orientations()) {
    const Eigen::Vector3d angles = kDegrees * yaw_pitch_roll().angles(rotation).reverse();
    return {angles, {angles.x() + 180, 180 - angles.y(), angles.z() + 180}};
  }
  const Eigen::Vector3d spindle = -rotation.col(2);
  const double sine = std::hypot(spindle.x(), spindle.y());
  const double tilt = kDegrees * std::atan2(sine, spindle.z());
  const bool by_a = name_ == "xyzac";
  double turn = kDegrees * (by_a ? std::atan2(spindle.x(), -spindle.y())
                                 : std::atan2(spindle.y(), spindle.x()));
  if (sine < kUpright) turn = std::isfinite(before[5]) ? before[5] : 0;
  if (by_a) return {{tilt, 0, turn}, {-tilt, 0, turn + 180}};
  return {{0, tilt, turn}, {0, -tilt, turn + 180}};
}

GcodeAxes GcodeDialect::axes(const Eigen::Isometry3d& pose, const GcodeAxes& before) const {
  std::vector<Eigen::Vector3d> all = solutions(pose.linear(), before);
  for (Eigen::Vector3d& angles : all)
    for (Eigen::Index i = 0; i < 3; ++i)
      angles[i] = near(angles[i], before[i + 3]);
  GcodeAxes axes;
  axes.head<3>() = 1e3 * pose.translation();
  axes.tail<3>() = *std::min_element(
      all.begin(), all.end(),
      [&](const auto& one, const auto& other) { return way(one, before) < way(other, before); });
  return axes;
}

}  // namespace tool_path_programs
