// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "tool_check/spin/spin.h"

namespace c4g_driver {
namespace {

double cost_of(const SpinArm& arm, const std::vector<SpinNode>& nodes, const Spin& spin) {
  double cost = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    cost += arm.cost(spin.joints[i - 1], spin.joints[i], nodes[i].seconds) +
            arm.strain(spin.joints[i]) * nodes[i].seconds;
  }
  return cost;
}

/// A sum of squares of the changes of turns, each coupled only to its neighbours.
class ChainOfTurns {
 public:
  ChainOfTurns(const SpinArm& arm, const std::vector<SpinNode>& nodes, const Spin& spin)
      : slope_(nodes.size(), 0), curve_(nodes.size(), 0), tie_(nodes.size(), 0) {
    std::vector<Joints> rates;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      rates.push_back(arm.rate(nodes[i], spin.turns[i], spin.joints[i]));
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const double weight = 2 / std::max(nodes[i].seconds, SpinArm::kLeastSeconds);
      const Joints way = (spin.joints[i] - spin.joints[i - 1]).cwiseQuotient(arm.speed());
      const Joints here = rates[i].cwiseQuotient(arm.speed());
      const Joints before = rates[i - 1].cwiseQuotient(arm.speed());
      slope_[i] += weight * way.dot(here);
      slope_[i - 1] -= weight * way.dot(before);
      curve_[i] += weight * here.squaredNorm();
      curve_[i - 1] += weight * before.squaredNorm();
      tie_[i] = -weight * here.dot(before);
      const auto [strain, more] = arm.strain_slope(spin.joints[i], rates[i]);
      slope_[i] += strain * nodes[i].seconds;
      curve_[i] += more * nodes[i].seconds;
    }
  }

  /// The changes [rad] of least cost, by Gaussian elimination along the chain (Thomas 1949).
  /// @param held turns that do not change
  /// @param damping [1/rad^2] of each change (Levenberg 1944)
  std::vector<double> least(const std::vector<bool>& held, double damping) const {
    const std::size_t count = slope_.size();
    std::vector<double> diagonal(count, 1), changes(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
      if (held[i]) continue;
      diagonal[i] = curve_[i] + damping;
      changes[i] = -slope_[i];
      if (i == 0 || held[i - 1]) continue;
      diagonal[i] -= tie_[i] * tie_[i] / diagonal[i - 1];
      changes[i] -= tie_[i] * changes[i - 1] / diagonal[i - 1];
    }
    for (std::size_t i = count; i-- > 0;) {
      if (held[i]) continue;
      if (i + 1 < count) changes[i] -= tie_[i + 1] * changes[i + 1];
      changes[i] /= diagonal[i];
    }
    return changes;
  }

 private:
  std::vector<double> slope_;
  std::vector<double> curve_;
  std::vector<double> tie_;  // coupling of each with the one before
};

struct Trial {
  Spin spin;
  std::vector<bool> held;
};

/// Makes the changes, or as much of each as is possible. A turn that could not change fully is held
/// from then on.
Trial changed(const SpinArm& arm, const std::vector<SpinNode>& nodes, const Trial& before,
              const std::vector<double>& changes) {
  constexpr int kHalvings = 4;  // chosen
  Trial trial = before;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double change = changes[i];
    for (int halved = 0; halved < kHalvings && change != 0; ++halved, change /= 2) {
      const double turn = before.spin.turns[i] + change;
      const auto joints = arm.joints(nodes[i], turn, before.spin.joints[i]);
      if (joints && arm.possible(*joints)) {
        trial.spin.turns[i] = turn;
        trial.spin.joints[i] = *joints;
        break;
      }
      trial.held[i] = true;
    }
  }
  return trial;
}

double largest(const std::vector<double>& changes) {
  double most = 0;
  for (const double change : changes)
    most = std::max(most, std::abs(change));
  return most;
}

}  // namespace

void refine_spin(const SpinArm& arm, const std::vector<SpinNode>& nodes, bool begins_there,
                 Spin& spin) {
  constexpr int kSteps = 40;             // chosen
  constexpr double kMostAtOnce = 0.5;    // [rad] chosen
  constexpr double kLeastChange = 2e-3;  // [rad] smaller ones end the search; chosen
  constexpr double kEnough = 1e-4;       // of the cost; chosen
  Trial best = {spin, std::vector<bool>(nodes.size(), false)};
  best.held.front() = begins_there;
  double cost = cost_of(arm, nodes, spin);
  double damping = cost / static_cast<double>(nodes.size());
  for (int step = 0; step < kSteps; ++step) {
    const auto changes = ChainOfTurns(arm, nodes, best.spin).least(best.held, damping);
    const double most = largest(changes);
    if (!(most > kLeastChange)) break;
    damping *= 4;
    if (most > kMostAtOnce) continue;
    Trial trial = changed(arm, nodes, best, changes);
    const double trial_cost = cost_of(arm, nodes, trial.spin);
    if (!(trial_cost < cost)) continue;
    damping /= 16;
    const bool enough = cost - trial_cost < kEnough * cost;
    best = std::move(trial);
    cost = trial_cost;
    if (enough) break;
  }
  spin = std::move(best.spin);
}

std::vector<Eigen::Isometry3d> spun_tips(const SpinPath& path, const std::vector<SpinNode>& nodes,
                                         const std::vector<double>& turns) {
  std::vector<Eigen::Isometry3d> tips = {spun(path.tips.front(), turns.front())};
  for (std::size_t node = 1; node < nodes.size(); ++node) {
    const std::size_t begin = nodes[node - 1].waypoint;
    for (std::size_t i = begin + 1; i <= nodes[node].waypoint; ++i) {
      const double seconds = path.seconds[i] - path.seconds[begin];
      const double share = nodes[node].seconds > 0 ? seconds / nodes[node].seconds : 1;
      const double turn = turns[node - 1] + share * (turns[node] - turns[node - 1]);
      tips.push_back(spun(path.tips[i], turn));
    }
  }
  return tips;
}

}  // namespace c4g_driver
