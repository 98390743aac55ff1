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
  profile.run(end, speed, 0, acceleration);
  return profile;
}

/// Moves from the present position to `end`, where it has the final speed.
void SpeedProfile::run(double end, double speed, double final_speed, double acceleration) {
  // the speed to accelerate to so that the rest of the way is just enough to brake
  const double squares = (speed_ * speed_ + final_speed * final_speed) / 2;
  const double peak = std::sqrt(acceleration * std::max(end - reached_, 0.0) + squares);
  change_speed(std::min(speed, std::max(peak, speed_)), acceleration);
  const double braking_way = (speed_ * speed_ - final_speed * final_speed) / (2 * acceleration);
  cruise(end - braking_way - reached_);
  change_speed(final_speed, acceleration);
}

namespace {

/// [1/s^2] squares of the highest speeds at the ends of the steps from which braking is possible.
std::vector<double> squares_ahead(const std::vector<LimitedWay>& steps, double acceleration) {
  std::vector<double> squares(steps.size(), 0);
  for (std::size_t i = steps.size() - 1; i > 0; --i) {
    const double slower = std::min(steps[i - 1].speed, steps[i].speed);
    const double way = steps[i].end - steps[i - 1].end;
    const double most = steps[i - 1].stop ? 0 : slower * slower;
    squares[i - 1] = std::min(most, squares[i] + 2 * acceleration * way);
  }
  return squares;
}

}  // namespace

SpeedProfile SpeedProfile::through(const std::vector<LimitedWay>& steps, double start,
                                   double initial_speed, double acceleration) {
  SpeedProfile profile;
  profile.reached_ = start;
  profile.speed_ = initial_speed;
  const std::vector<double> squares = squares_ahead(steps, acceleration);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double way = steps[i].end - profile.reached_;
    if (way <= 0) continue;
    const double square = profile.speed_ * profile.speed_;
    const double reach = 2 * acceleration * way;
    const double final_square = std::max(std::min(squares[i], square + reach), square - reach);
    profile.run(steps[i].end, std::max(steps[i].speed, std::sqrt(std::max(final_square, 0.0))),
                std::sqrt(std::max(final_square, 0.0)), acceleration);
    profile.reached_ = steps[i].end;
  }
  profile.end_ = steps.back().end;
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
  phases_->push_back(
      {duration_, duration, reached_, speed_, to > speed_ ? acceleration : -acceleration});
  duration_ += duration;
  reached_ += (speed_ + to) / 2 * duration;
  speed_ = to;
}

void SpeedProfile::cruise(double way) {
  if (way <= 0 || speed_ <= 0) return;
  phases_->push_back({duration_, way / speed_, reached_, speed_, 0});
  duration_ += way / speed_;
  reached_ += way;
}

/// None once it is over.
const SpeedProfile::Phase* SpeedProfile::phase_at(double time) const {
  if (phases_->empty() || time >= duration_) return nullptr;
  const auto later =
      std::upper_bound(phases_->begin() + 1, phases_->end(), time,
                       [](double wanted, const Phase& phase) { return wanted < phase.begin; });
  return &*std::prev(later);
}

double SpeedProfile::position(double time) const {
  const Phase* const phase = phase_at(time);
  if (phase == nullptr) return end_;
  const double passed = std::clamp(time - phase->begin, 0.0, phase->duration);
  return phase->position + passed * (phase->speed + passed * phase->acceleration / 2);
}

double SpeedProfile::speed(double time) const {
  const Phase* const phase = phase_at(time);
  if (phase == nullptr) return 0;
  return phase->speed + std::clamp(time - phase->begin, 0.0, phase->duration) * phase->acceleration;
}

}  // namespace scan_cell_sim
