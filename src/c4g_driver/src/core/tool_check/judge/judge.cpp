// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_check/judge/judge.h"

#include <fmt/format.h>

#include <cmath>

#include "c4g_driver/collision_scene.h"
#include "robot/inverse_kinematics.h"
#include "robot/path_check.h"
#include "tool_check/judge/findings.h"
#include "tool_check/judge/tool_line.h"
#include "tool_check/judge/way_speeds.h"

namespace c4g_driver {
namespace {

using Kind = ToolFault::Kind;

constexpr double kBeyondLimit = 1e-6;  // [rad] or [m] beyond a limit; chosen

/// The kind of posture that couples these joints, in an arm whose last three axes meet in a point.
const char* posture_name(const std::string& tied) {
  const auto has = [&](const char* joint) { return tied.find(joint) != std::string::npos; };
  if (has("J1")) return "the wrist stands above axis 1";
  if (has("J2") || has("J3")) return "the arm is stretched out";
  return "the wrist is straight";
}

/// Checks one place after the other.
class Judge {
 public:
  explicit Judge(const ToolCheckSubject& subject) : subject_(subject), speeds_(subject, findings_) {
    for (JointMargin& margin : check_.margins)
      margin.margin = std::numeric_limits<double>::infinity();
    check_.joints.assign(subject.motion.waypoints.size(),
                         Joints::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (const ToolWaypoint& waypoint : subject.motion.waypoints)
      check_.tips.push_back(waypoint.tip);
  }

  /// Begins the way to a waypoint, before its places.
  void enter(const TrackPlace& place, const ToolLine& line) {
    constexpr double kHalfTurn = 179.9 * M_PI / 180;  // [rad] as between the poses of an arc
    said_lost_ = false;
    if (line.angle() > kHalfTurn) {
      findings_.add(place, {Kind::kHalfTurn, 1, "orientation"}, [&] {
        return Said(fmt::format("{:g} rad from that of the waypoint before", line.angle()),
                    "add a waypoint between: otherwise the direction of the turn is ambiguous");
      });
    }
    speeds_.enter(place, line);
  }

  /// The start of a way was the end of the one before, so only its speeds are new.
  void look(const TrackPlace& place) {
    const bool begin = place.waypoint > 0 && place.way <= 0;
    if (!begin) check_place(place);
    if (place.waypoint > 0 && place.reached && place.tied.empty()) speeds_.look(place);
  }

  ToolCheck take() {
    check_.faults = findings_.take();
    check_.slowest = speeds_.slowest();
    return std::move(check_);
  }

 private:
  void check_place(const TrackPlace& place) {
    check_workspace_at(place);
    if (!place.reached) return say_lost(place);
    beyond_ = false;
    nearest_ = place.joints;
    if (place.way >= 1) check_.joints[place.waypoint] = place.joints;
    check_singular(place);
    check_ranges(place);
    if (subject_.scene != nullptr) check_collisions(place);
  }

  void say_lost(const TrackPlace& place) {
    if (said_lost_) return;
    said_lost_ = true;
    const double gap = gap_at(place);
    if (gap > 0) {
      findings_.add(place, {Kind::kReach, 1}, [&] {
        return Said(fmt::format("out of reach by {:g} m", gap),
                    "move the part nearer to the robot, or tilt the tool");
      });
    } else {
      findings_.add(place, {Kind::kPosture, 1}, [&] {
        return Said("within reach only in another posture of the robot",
                    "move the part, turn or tilt the tool, or divide the path here");
      });
    }
  }

  /// [m] by which a place is out of reach in any posture. All postures are searched only at the
  /// start of a stretch that is out of reach, since the search is slow.
  double gap_at(const TrackPlace& place) {
    constexpr double kNone = 1e-4;  // [m] accuracy of the search; chosen
    double gap = gap_from(subject_.robot, place.flange, nearest_);
    if (gap > kNone && !beyond_) {
      const Postures postures = postures_for(subject_.robot, place.flange, nearest_);
      gap = postures.gap;
      if (!postures.joints.empty()) nearest_ = postures.joints.front();
    }
    beyond_ = gap > kNone;
    return beyond_ ? gap : 0;
  }

  void check_singular(const TrackPlace& place) {
    if (!place.tied.empty()) {
      findings_.add(place, {Kind::kSingular, 1}, [&] {
        return Said("singular posture of " + place.tied + ": " + posture_name(place.tied),
                    "turn or tilt the tool there, or move the part");
      });
    }
    if (place.jump <= kTurnsOver) return;
    findings_.add(place, {Kind::kTurnsOver, place.jump, joint_name(place.jumping), place.jumping},
                  [&] {
                    return Said(fmt::format("turns over by {:g} rad in one step", place.jump),
                                "turn or tilt the tool there, or move the part");
                  });
  }

  void check_ranges(const TrackPlace& place) {
    const double kept = subject_.parameters.joint_margin;
    for (int joint = 0; joint < 6; ++joint) {
      const double lower = subject_.limits.joint_lower[joint];
      const double upper = subject_.limits.joint_upper[joint];
      const double margin = std::min(place.joints[joint] - lower, upper - place.joints[joint]);
      JointMargin& least = check_.margins[static_cast<std::size_t>(joint)];
      if (margin < least.margin) least = {margin, place.waypoint};
      if (margin >= kept - kBeyondLimit) continue;
      findings_.add(place, {Kind::kJointRange, kept - margin, joint_name(joint), joint}, [&] {
        return Said(
            fmt::format("{:g} rad", place.joints[joint]),
            fmt::format("its range is {}, with {:g} rad kept free at each end: turn or tilt "
                        "the tool, or move the part",
                        range(lower, upper, " rad"), kept));
      });
    }
  }

  void check_collisions(const TrackPlace& place) {
    for (const Collision& collision :
         subject_.scene->collisions(place.joints, subject_.motion.flange_to_tip)) {
      const bool known = std::isfinite(collision.depth);
      const std::string what = collision.moving + " and " + collision.standing;
      findings_.add(place, {Kind::kCollision, known ? collision.depth : 0, what}, [&] {
        return Said(known ? fmt::format("collide by {:g} m", collision.depth) : "collide",
                    "turn or tilt the tool there, or move the part; or correct the shapes");
      });
    }
  }

  void check_workspace_at(const TrackPlace& place) {
    for (int axis = 0; axis < 3; ++axis) {
      const double lower = subject_.limits.workspace_min[axis];
      const double upper = subject_.limits.workspace_max[axis];
      const double value = place.flange.translation()[axis];
      const double outside = std::max(lower - value, value - upper);
      if (outside <= kBeyondLimit) continue;
      findings_.add(place,
                    {Kind::kWorkspace, outside, fmt::format("{} of the flange", "xyz"[axis])}, [&] {
                      return Said(fmt::format("{:g} m", value),
                                  "the workspace is " + range(lower, upper, " m") +
                                      ": move the part, or turn or tilt the tool");
                    });
    }
  }

  const ToolCheckSubject& subject_;
  ToolCheck check_;
  Findings findings_;
  WaySpeeds speeds_;
  bool beyond_ = false;              // the place before was out of reach
  bool said_lost_ = false;           // on this way
  Joints nearest_ = Joints::Zero();  // [rad] at the place before, or nearest to it
};

}  // namespace

ToolCheck judge(const Track& track, const ToolCheckSubject& subject) {
  Judge judge(subject);
  for (const TrackPlace& place : track.places) {
    if (place.waypoint > 0 && place.way <= 0)
      judge.enter(place, ToolLine(subject.motion, place.waypoint));
    judge.look(place);
  }
  return judge.take();
}

}  // namespace c4g_driver
