// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "follow_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>

#include "scan_cell_common/clock/host_clock.h"
#include "scan_cell_common/errors/errors.h"
#include "trial_setup.h"

namespace c4g_driver {
namespace {

using scan_cell_common::Nanoseconds;
using scan_cell_sim::Controller;

constexpr double kZone = 0.001;         // [m]
constexpr double kSpeed = 0.5;          // [m/s] chosen
constexpr Nanoseconds kLook = 200'000;  // [ns] between two looks at the truth
constexpr double kFarthest = 0.002;     // [m] the zone plus the way between two looks

/// A random walk within 0.1 m, with different outputs on along each line.
class Walk {
 public:
  ToolMotion from(const Eigen::Isometry3d& flange) {
    ToolMotion motion;
    motion.flange_to_tip.translation() << 0.02, 0.01, 0.15;
    const Eigen::Vector3d middle = (looking_down(0) * motion.flange_to_tip).translation();
    ToolWaypoint waypoint{flange * motion.flange_to_tip, kSpeed, kZone, 1};
    motion.waypoints.push_back(waypoint);
    const int lines = std::uniform_int_distribution<int>(1, 12)(random_);
    for (int line = 1; line <= lines; ++line) {
      const Eigen::Vector3d place =
          middle + 0.1 * Eigen::Vector3d(part_(random_), part_(random_), part_(random_));
      Eigen::Vector3d step = place - waypoint.tip.translation();
      step *= std::uniform_real_distribution<double>(0.01, 0.03)(random_) / step.norm();
      waypoint.tip.translation() += step;
      waypoint.outputs = static_cast<std::uint32_t>(line + 1);
      motion.waypoints.push_back(waypoint);
    }
    return motion;
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> part_{-1, 1};
};

/// What the controller really did with a path between two instants.
class Truth {
 public:
  Truth(const Controller& controller, const ToolMotion& motion, Nanoseconds begin,
        Nanoseconds end) {
    std::uint32_t outputs = controller.outputs_at(begin);
    for (Nanoseconds look = begin; look < end + kLook; look += kLook) {
      const Nanoseconds instant = std::min(look, end);
      const std::uint32_t now = controller.outputs_at(instant);
      if (now == outputs) continue;
      // Outputs go off at the end; else they become those of the next waypoint, at its place.
      const bool is_end = now == 0 && passed_ > 0;
      const bool is_next = now == passed_ + 1 && now <= motion.waypoints.size();
      in_order_ = in_order_ && !ended_ && (is_end || is_next);
      if (is_next) {
        const Eigen::Isometry3d tip = controller.flange_at(instant) * motion.flange_to_tip;
        const Eigen::Isometry3d& waypoint = motion.waypoints[passed_].tip;
        in_order_ = in_order_ && (tip.translation() - waypoint.translation()).norm() < kFarthest;
        ++passed_;
      }
      ended_ = ended_ || is_end;
      outputs = now;
    }
  }

  bool in_order() const { return in_order_; }

  /// Whether no output is on at the end.
  bool is_off() const { return ended_ || passed_ == 0; }

  std::string text() const {
    return fmt::format("{} waypoints passed, {}, outputs {}", passed_,
                       in_order_ ? "in order" : "not in order", ended_ ? "off again" : "still on");
  }

  /// Whether it passed all waypoints but the last one, whose outputs go off at once.
  bool is_whole(const ToolMotion& motion) const {
    return ended_ && passed_ + 1 >= motion.waypoints.size();
  }

 private:
  std::size_t passed_ = 0;  // waypoints
  bool in_order_ = true;
  bool ended_ = false;
};

class Trials {
 public:
  Trials(Controller& controller, Client& client) : controller_(controller), client_(client) {}

  void follow_one() {
    wait_for_link(client_);
    const ToolMotion motion = walk_.from(controller_.state().flange);
    const Nanoseconds begin = scan_cell_common::host_now();
    const std::uint64_t begun_before = controller_.motions_begun();
    bool reached = false, refused = false;
    std::string reason;
    try {
      refused = true;
      client_.follow(motion);
      refused = false;
      const Goal goal = client_.wait_for_goal(kPatience);
      reached = goal.outcome() == Goal::Outcome::kReached;
      reason = goal.message();
    } catch (const scan_cell_common::Error& error) {
      reason = error.what();
    }
    wait_for_link(client_);  // a begin that was in transit has arrived by then, too
    const auto begun = controller_.motions_begun() - begun_before;
    const Truth truth(controller_, motion, begin, scan_cell_common::host_now());
    judge(truth, motion, begun, {reached, refused});
    if (!reached) trial_.reasons.push_back(reason);
  }

  FollowTrial take() { return std::move(trial_); }

 private:
  struct Told {
    bool reached, refused;
  };

  void judge(const Truth& truth, const ToolMotion& motion, std::uint64_t begun, const Told& told) {
    const bool reached = told.reached;
    const bool wrong =
        told.refused ? begun > 0 : reached && (begun == 0 || !truth.is_whole(motion));
    if (begun > 1)
      ++trial_.twice;
    else if (!truth.in_order())
      ++trial_.out_of_order;
    else if (wrong || !truth.is_off())
      ++trial_.in_secret;
    else if (begun == 0)
      ++trial_.refused;
    else
      ++(reached ? trial_.followed : trial_.ended_early);
    if (begun > 1 || !truth.in_order() || wrong || !truth.is_off())
      trial_.faults.push_back(
          fmt::format("{} waypoints, begun {} times, {}: {}", motion.waypoints.size(), begun,
                      reached ? "reported as followed" : "not reported as followed", truth.text()));
    if (reached) trial_.waypoints += motion.waypoints.size();
  }

  Controller& controller_;
  Client& client_;
  Walk walk_;
  FollowTrial trial_;
};

}  // namespace

FollowTrial run_follow_trial(const std::shared_ptr<const RobotModel>& robot, int paths,
                             const scan_cell_sim::ControllerFaults& faults) {
  scan_cell_sim::ControllerOptions options;
  options.port = 0;
  Controller controller(options);
  Client client(options_for(controller, robot), nullptr);
  wait_for_link(client);
  client.move_to_pose(looking_down(0), 0);
  client.wait_for_goal(kPatience);
  controller.set_faults(faults);
  Trials trials(controller, client);
  const auto start = std::chrono::steady_clock::now();
  for (int path = 0; path < paths; ++path)
    trials.follow_one();
  FollowTrial trial = trials.take();
  trial.duration = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return trial;
}

}  // namespace c4g_driver
