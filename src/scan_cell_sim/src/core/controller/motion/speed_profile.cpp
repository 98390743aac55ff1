// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/motion/speed_profile.h"

#include <algorithm>
#include <cmath>

namespace scan_cell_sim {

SpeedProfile SpeedProfile::rest(double position) {
  SpeedProfile profile;
  profile.end_ = position;
  return profile;
}

SpeedProfile SpeedProfile::trapezoid(double start, double end, double initial_speed, double speed,
                                     double acceleration) {
  SpeedProfile profile;
  profile.reached_ = start;
  profile.speed_ = initial_speed;
  profile.end_ = end;
  const double way = end - start;
  // the speed from which the rest of the way is just enough to brake, after accelerating until then
  const double peak = std::sqrt(acceleration * way + initial_speed * initial_speed / 2);
  profile.change_speed(std::min(speed, std::max(peak, initial_speed)), acceleration);
  const double braking_way = profile.speed_ * profile.speed_ / (2 * acceleration);
  profile.cruise(end - braking_way - profile.reached_);
  profile.change_speed(0, acceleration);
  return profile;
}

SpeedProfile SpeedProfile::brake(double start, double initial_speed, double deceleration) {
  SpeedProfile profile;
  profile.reached_ = start;
  profile.speed_ = initial_speed;
  profile.change_speed(0, deceleration);
  profile.end_ = profile.reached_;
  return profile;
}

void SpeedProfile::change_speed(double to, double acceleration) {
  const double duration = std::abs(to - speed_) / acceleration;
  if (duration <= 0) return;
  phases_.push_back({duration, reached_, speed_, to > speed_ ? acceleration : -acceleration});
  reached_ += (speed_ + to) / 2 * duration;
  speed_ = to;
}

void SpeedProfile::cruise(double way) {
  if (way <= 0 || speed_ <= 0) return;
  phases_.push_back({way / speed_, reached_, speed_, 0});
  reached_ += way;
}

double SpeedProfile::position(double time) const {
  for (const Phase& phase : phases_) {
    if (time < phase.duration) {
      const double passed = std::max(time, 0.0);
      return phase.position + passed * (phase.speed + passed * phase.acceleration / 2);
    }
    time -= phase.duration;
  }
  return end_;
}

double SpeedProfile::speed(double time) const {
  for (const Phase& phase : phases_) {
    if (time < phase.duration) return phase.speed + std::max(time, 0.0) * phase.acceleration;
    time -= phase.duration;
  }
  return 0;
}

double SpeedProfile::duration() const {
  double sum = 0;
  for (const Phase& phase : phases_)
    sum += phase.duration;
  return sum;
}

}  // namespace scan_cell_sim
