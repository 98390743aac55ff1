// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/pose_convention.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "path/number_text.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/euler_angles.h"
#include "scan_cell_common/pose/unit_quaternion.h"
#include "scan_cell_common/pose/units.h"

namespace tool_paths {
namespace {

using scan_cell_common::EulerSequence;
using scan_cell_common::UnusableInput;

using scan_cell_common::kDegree;

/// Drops the rounding error of the conversion to millimetres or degrees.
double rounded(double value) {
  constexpr double kSteps = 1e9;  // per millimetre or degree: far below what anyone measures
  constexpr double kMost = 1e6;   // [mm] or [deg]: above, a double has no such steps
  if (!(std::abs(value) < kMost)) return value;
  return std::round(value * kSteps) / kSteps + 0.0;  // -0 is 0
}

Eigen::Matrix3d from_tool_vector(const Eigen::Vector3d& vector, const std::string& where) {
  constexpr double kUnit = 1e-3;  // deviation from length 1: vectors of three digits; chosen
  if (!(std::abs(vector.norm() - 1) < kUnit)) {
    throw UnusableInput(where, fmt::format("a tool vector of length {:.6g}", vector.norm()),
                        "give unit vectors, or say that it is not one (--process-values)");
  }
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), vector).toRotationMatrix();
}

Eigen::Matrix3d from_rotation_vector(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Vector3d angles_of(const PoseConvention& convention, const Eigen::Quaterniond& rotation) {
  if (convention.orientation == OrientationKind::kEuler) {
    return EulerSequence(convention.euler).angles(rotation.toRotationMatrix());
  }
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

}  // namespace

PoseConvention convention_for(const ToolPath& path, const PoseConvention& convention) {
  const bool as_it_is = path.has_orientation == (convention.orientation != OrientationKind::kNone);
  if (as_it_is) return convention;
  PoseConvention result = convention;
  result.orientation = path.has_orientation ? OrientationKind::kQuaternion : OrientationKind::kNone;
  result.names.clear();
  if (path.has_orientation) result.names = {"qx", "qy", "qz", "qw"};
  return result;
}

std::size_t number_count(const PoseConvention& convention) {
  return 3 + convention.names.size();
}

Eigen::Isometry3d pose_from(const PoseConvention& convention, const std::vector<double>& numbers,
                            const std::string& where) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << numbers[0], numbers[1], numbers[2];
  pose.translation() *= scan_cell_common::metres_per(convention.units);
  if (convention.orientation == OrientationKind::kNone) return pose;
  const Eigen::Vector3d three(numbers[3], numbers[4], numbers[5]);
  const Eigen::Vector3d angles = (convention.degrees ? kDegree : 1) * three;
  if (convention.orientation == OrientationKind::kQuaternion) {
    pose.linear() = scan_cell_common::rotation_from(
        Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]), where);
  } else if (convention.orientation == OrientationKind::kEuler) {
    pose.linear() = EulerSequence(convention.euler).rotation(angles);
  } else if (convention.orientation == OrientationKind::kRotationVector) {
    pose.linear() = from_rotation_vector(angles);
  } else {
    pose.linear() = from_tool_vector(three, where);
  }
  return pose;
}

std::vector<double> numbers_of(const PoseConvention& convention, const Eigen::Vector3d& position,
                               const Eigen::Quaterniond& rotation) {
  const double metres = scan_cell_common::metres_per(convention.units);
  std::vector<double> numbers;
  for (const double coordinate : position)
    numbers.push_back(metres == 1 ? coordinate : rounded(coordinate / metres));
  switch (convention.orientation) {
    case OrientationKind::kNone:
      break;
    case OrientationKind::kQuaternion:
      for (const double part : rotation.coeffs())
        numbers.push_back(part);
      break;
    case OrientationKind::kEuler:
    case OrientationKind::kRotationVector:
      for (const double angle : angles_of(convention, rotation))
        numbers.push_back(convention.degrees ? rounded(angle / kDegree) : angle);
      break;
    case OrientationKind::kToolVector:
      for (const double part : Eigen::Vector3d(rotation.toRotationMatrix().col(2)))
        numbers.push_back(part + 0.0);
      break;
  }
  return numbers;
}

void carry_spin_along(Segment& segment) {
  for (std::size_t i = 1; i < segment.waypoints.size(); ++i) {
    const Eigen::Matrix3d before = segment.waypoints[i - 1].pose.linear();
    Eigen::Isometry3d& pose = segment.waypoints[i].pose;
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(before.col(2), pose.linear().col(2));
    pose.linear() = (turn * Eigen::Quaterniond(before)).normalized().toRotationMatrix();
  }
}

void check_angles(const PoseConvention& convention, const std::vector<double>& angles,
                  const std::string& source) {
  constexpr double kTurn = 2 * M_PI;
  constexpr double kExact = 2e-4;  // [rad] 3.1416 is half a turn; no one means it in degrees
  if (!convention.degrees || angles.empty()) return;
  const auto is_beyond = [](double angle) { return std::abs(angle) > kTurn + kExact; };
  const auto is_half_turn = [](double angle) {
    return std::abs(std::abs(angle) - M_PI) < kExact || std::abs(std::abs(angle) - M_PI_2) < kExact;
  };
  if (std::any_of(angles.begin(), angles.end(), is_beyond)) return;
  const auto found = std::find_if(angles.begin(), angles.end(), is_half_turn);
  if (found == angles.end()) return;
  throw UnusableInput(source, fmt::format("an angle of {} degrees, but none beyond 6.28", *found),
                      "give degrees, or say that they are radians (--radians)");
}

}  // namespace tool_paths
