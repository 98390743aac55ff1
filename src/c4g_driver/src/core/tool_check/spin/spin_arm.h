// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <utility>

#include "tool_check/spin/spin_nodes.h"

namespace c4g_driver {

/// The robot at a node, at a turn of the tool.
class SpinArm {
 public:
  /// The least that a way counts, so that costs are finite where the path stands still.
  static constexpr double kLeastSeconds = 1e-3;

  /// @param subject outlives it
  explicit SpinArm(const ToolCheckSubject& subject);

  /// In the posture of `near` [rad].
  std::optional<Joints> joints(const SpinNode& node, double turn, const Joints& near) const;

  /// By the turn [rad/rad].
  Joints rate(const SpinNode& node, double turn, const Joints& joints) const;

  /// Whether the robot may stand so: ranges, box, no singular posture, no collision.
  bool possible(const Joints& joints) const;

  /// What standing so costs [1/s], more towards the ends of the ranges.
  double strain(const Joints& joints) const;

  /// First and second derivative of strain() by a turn, with the joints at these rates.
  std::pair<double, double> strain_slope(const Joints& joints, const Joints& rate) const;

  /// What it costs to go there in so many seconds: as much as all joints together use of their
  /// speeds, squared, over the time. Infinite if the posture changes.
  double cost(const Joints& from, const Joints& to, double seconds) const;

  const Joints& speed() const { return subject_.robot.speed(); }  // [rad/s]

 private:
  const ToolCheckSubject& subject_;
  Eigen::Isometry3d tip_to_flange_;
  Joints lower_;  // [rad] margin taken off
  Joints upper_;
};

}  // namespace c4g_driver
