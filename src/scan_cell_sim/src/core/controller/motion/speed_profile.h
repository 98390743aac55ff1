// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace scan_cell_sim {

/// Way over time in phases of constant acceleration: the trapezoidal speed of a robot along its
/// path. Units are those of the path, per second.
class SpeedProfile {
 public:
  /// At rest at `position`.
  static SpeedProfile rest(double position);

  /// From `start` to rest at `end` >= start, at `speed` if the way is long enough.
  /// @param initial_speed at `start`; may be above `speed`, but the way must be long enough to
  /// brake
  static SpeedProfile trapezoid(double start, double end, double initial_speed, double speed,
                                double acceleration);

  /// Brakes to rest.
  static SpeedProfile brake(double start, double initial_speed, double deceleration);

  double position(double time) const;
  double speed(double time) const;
  double duration() const;
  double end() const { return end_; }

 private:
  struct Phase {
    double duration;
    double position;
    double speed;
    double acceleration;
  };

  void change_speed(double to, double acceleration);
  void cruise(double way);

  std::vector<Phase> phases_;
  double reached_ = 0;  // position and speed at the end of the last phase
  double speed_ = 0;
  double end_ = 0;
};

}  // namespace scan_cell_sim
