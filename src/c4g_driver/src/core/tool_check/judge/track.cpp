// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/judge/track.h"

#include "robot/inverse_kinematics.h"
#include "robot/path_check.h"
#include "tool_check/judge/tool_line.h"

namespace c4g_driver {
namespace {

/// Follows the path from place to place.
class Tracker {
 public:
  Tracker(const RobotModel& robot, const ToolMotion& motion, const Joints& start)
      : robot_(robot), tip_to_flange_(motion.flange_to_tip.inverse()), before_(start) {
    track_.places.reserve(3 * motion.waypoints.size());
    look(nullptr, 0, 1, motion.waypoints.front().tip);
  }

  void follow(const ToolLine& line, std::size_t waypoint) {
    begin(line, waypoint);
    const int steps = line.steps();
    for (int step = 1; step <= steps; ++step) {
      const double way = static_cast<double>(step) / steps;
      look(&line, waypoint, way, line.tip(way));
    }
  }

  Track take() { return std::move(track_); }

 private:
  using Factors = Eigen::PartialPivLU<RobotModel::Jacobian>;

  /// Adds the place where the line before ended, with the rates of this line.
  void begin(const ToolLine& line, std::size_t waypoint) {
    TrackPlace place = track_.places.back();
    place.waypoint = waypoint;
    place.way = 0;
    place.jump = 0;
    set_rates(place, line);
    track_.places.push_back(place);
  }

  void look(const ToolLine* line, std::size_t waypoint, double way, const Eigen::Isometry3d& tip) {
    TrackPlace place;
    place.waypoint = waypoint;
    place.way = way;
    place.tip = tip;
    place.flange = tip * tip_to_flange_;
    place.joints = place.rate = Joints::Zero();
    if (const auto joints = step_to(robot_, place.flange, before_)) reach(place, *joints);
    if (line != nullptr) set_rates(place, *line);
    track_.places.push_back(place);
  }

  void reach(TrackPlace& place, const Joints& joints) {
    const bool follows = !track_.places.empty() && track_.places.back().reached;
    if (follows) place.jump = (joints - before_).cwiseAbs().maxCoeff(&place.jumping);
    place.reached = true;
    place.joints = before_ = joints;
    const RobotModel::Jacobian jacobian = robot_.jacobian_at(joints);
    place.tied = singular_joints(jacobian);
    factors_.compute(jacobian);
  }

  void set_rates(TrackPlace& place, const ToolLine& line) const {
    const Eigen::Matrix<double, 6, 1> rate = line.flange_rate(place.tip, place.flange);
    place.flange_rate = rate.head<3>().norm();
    place.rate.setZero();
    if (place.reached && place.tied.empty()) place.rate = factors_.solve(rate);
  }

  const RobotModel& robot_;
  const Eigen::Isometry3d tip_to_flange_;
  Joints before_;    // [rad] at the last place reached
  Factors factors_;  // of the Jacobian there
  Track track_;
};

}  // namespace

Track track(const RobotModel& robot, const ToolMotion& motion, const Joints& start) {
  Tracker tracker(robot, motion, start);
  for (std::size_t waypoint = 1; waypoint < motion.waypoints.size(); ++waypoint)
    tracker.follow(ToolLine(motion, waypoint), waypoint);
  return tracker.take();
}

}  // namespace c4g_driver
