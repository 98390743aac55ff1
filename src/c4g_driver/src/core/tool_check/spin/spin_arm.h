// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "tool_check/spin/spin_nodes.h"

namespace c4g_driver {

/// The robot at a node with a turn of the tool.
class SpinArm {
 public:
  /// Least duration of a way, so that costs are finite where the path stands still.
  static constexpr double kLeastSeconds = 1e-3;

  /// @param subject must outlive this object
  explicit SpinArm(const ToolCheckSubject& subject);

  /// Joints [rad] in the posture of `near` [rad].
  std::optional<Joints> joints(const SpinNode& node, double turn, const Joints& near) const;

  /// Derivative of the joints by the turn [rad/rad].
  Joints rate(const SpinNode& node, double turn, const Joints& joints) const;

  /// Whether the robot may stand there: within ranges and box, no singular posture, no collision.
  bool possible(const Joints& joints) const;

  /// Cost of standing there [1/s], which grows towards the ends of the ranges.
  double strain(const Joints& joints) const;

  /// First and second derivative of strain() by the turn, with the joints changing at these rates.
  std::pair<double, double> strain_slope(const Joints& joints, const Joints& rate) const;

  /// Cost of a move in this time [s]: the sum of (change / speed)^2 over the joints, divided by the
  /// time. Infinite if the posture changes.
  double cost(const Joints& from, const Joints& to, double seconds) const;

  const Joints& speed() const { return subject_.robot.speed(); }  // [rad/s]

 private:
  const ToolCheckSubject& subject_;
  Eigen::Isometry3d tip_to_flange_;
  Joints lower_;  // [rad] reduced by the margin
  Joints upper_;
};

}  // namespace c4g_driver
