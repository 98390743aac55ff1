// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

namespace scan_cell_sim {

/// A part of a way with a speed limit of its own.
struct LimitedWay {
  double end;    // it begins where the one before ends
  double speed;  // the most on it
  bool stop;     // at its end
};

/// Way over time in phases of constant acceleration: the trapezoidal speed of a robot along its
/// path. Units are those of the path, per second.
class SpeedProfile {
 public:
  /// At rest at `position`.
  static SpeedProfile rest(double position);

  /// From `start` to rest at `end` >= start, reaching `speed` if the way is long enough.
  /// @param initial_speed at `start`; may be above `speed`, but the way must be long enough to
  /// brake
  static SpeedProfile trapezoid(double start, double end, double initial_speed, double speed,
                                double acceleration);

  /// From `start` to rest at the end of the last step, as fast as the steps and the acceleration
  /// allow. It brakes ahead of a slower step. A speed that is too high at `start` is reduced.
  static SpeedProfile through(const std::vector<LimitedWay>& steps, double start,
                              double initial_speed, double acceleration);

  /// Brakes to rest.
  static SpeedProfile brake(double start, double initial_speed, double deceleration);

  double position(double time) const;
  double speed(double time) const;
  double duration() const { return duration_; }
  double end() const { return end_; }

 private:
  struct Phase {
    double begin;  // time
    double duration;
    double position;
    double speed;
    double acceleration;
  };

  void change_speed(double to, double acceleration);
  void cruise(double way);
  void run(double end, double speed, double final_speed, double acceleration);
  const Phase* phase_at(double time) const;

  // not changed once it is made: copies share them
  std::shared_ptr<std::vector<Phase>> phases_ = std::make_shared<std::vector<Phase>>();
  double duration_ = 0;
  double reached_ = 0;  // position and speed at the end of the last phase
  double speed_ = 0;
  double end_ = 0;
};

}  // namespace scan_cell_sim
