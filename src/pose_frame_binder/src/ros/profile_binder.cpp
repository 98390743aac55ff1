// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "profile_binder.h"

#include <fmt/format.h>

#include <boost/make_shared.hpp>
#include <cmath>
#include <limits>
#include <sstream>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/conversions.h"

namespace pose_frame_binder {

using scan_cell_common::from_ros;
using scan_cell_common::to_ros;
using scan_cell_msgs::BoundProfile;
using scan_cell_msgs::BoundProfileConstPtr;
using scan_cell_msgs::PeakProfile;
using scan_cell_msgs::TriggerEvent;

namespace {

BoundProfileConstPtr to_message(const PeakProfile& profile, const Match& match,
                                const std::string& frame) {
  const auto message = boost::make_shared<BoundProfile>();
  BoundProfile& bound = *message;
  bound.header.stamp = to_ros(match.pulse.time);
  bound.header.frame_id = frame;
  bound.profile = profile;
  bound.profile.laser = match.laser;
  bound.pose = scan_cell_common::to_ros_pose(match.pose);
  bound.pass_index = match.pass;
  bound.match.rule = static_cast<std::uint8_t>(match.rule);
  bound.match.frame_counter = profile.frame_counter;
  bound.match.arming = match.pulse.arming;
  bound.match.trigger_count = match.pulse.count;
  bound.match.time_to_before = match.time_to_before;
  bound.match.time_to_after = match.time_to_after;
  bound.match.position_error_bound = match.position_error_bound;
  return message;
}

/// Returns NaN if the quaternion is not of unit length: one of zeros would become the identity.
Eigen::Isometry3d pose_of(const geometry_msgs::Transform& transform) {
  if (scan_cell_common::is_unit(from_ros(transform.rotation))) return from_ros(transform);
  Eigen::Isometry3d none;
  none.matrix().setConstant(std::numeric_limits<double>::quiet_NaN());
  return none;
}

Eigen::Isometry3d in_fixed_frame(const geometry_msgs::PoseStamped& pose, const std::string& name,
                                 const Frames& frames, const Eigen::Isometry3d& fixed_to_base) {
  const auto flange = scan_cell_common::checked_from_ros<scan_cell_common::Refused>(
      pose.pose, "orientation of the " + name);
  if (pose.header.frame_id == frames.fixed) return flange;
  if (pose.header.frame_id == frames.base) return fixed_to_base * flange;
  throw scan_cell_common::Refused(name, "in frame '" + pose.header.frame_id + "'",
                                  "give it in " + frames.fixed + " or " + frames.base);
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, Frames& frames) {
  const auto add = [&table](const std::string& name, std::string& frame,
                            const std::string& meaning) {
    table.add(name, frame, meaning);
    if (frame.empty() || frame.front() == '/')
      table.refuse(name, "'" + frame + "'", "give the frame's name, without a leading slash");
  };
  add("fixed_frame", frames.fixed, "poses are bound in it");
  add("base_frame", frames.base, "the robot's base");
  add("flange_frame", frames.flange, "the robot's flange");
}

void describe(scan_cell_common::ParameterTable& table, ConstantSpeed& motion) {
  constexpr double kFarthest = 100;  // [m] chosen: beyond any cell
  constexpr int kNumbers = 7;        // of a pose
  const auto add = [&table](const std::string& name, Eigen::Isometry3d& pose) {
    std::vector<double> numbers;
    table.add(name, numbers, {-kFarthest, kFarthest, "m"},
              "`constant_speed`: x y z qx qy qz qw in the fixed frame", kNumbers);
    if (!numbers.empty()) pose = pose_from(table.full_name(name), numbers);
  };
  add("start", motion.start);
  add("end", motion.end);
  table.add("speed", motion.speed, {0, 100, "m/s"}, "`constant_speed`: from start to end");
  table.add("frame_rate", motion.frame_rate, {0, 1e5, "Hz"},
            "`constant_speed`: rate of the frames");
  std::string moving = motion.object_moves ? "object" : "scanner";
  table.choice("moving", moving, {"object", "scanner"},
               "`constant_speed`: object: a conveyor carries the object from start to end, and the "
               "scanner stands at start");
  motion.object_moves = moving == "object";
}

std::string find_fault(const PeakProfile& profile) {
  if (profile.packets_lost > 0) return fmt::format("{} packets missing", profile.packets_lost);
  if (profile.width.size() != profile.position.size() ||
      profile.intensity.size() != profile.position.size()) {
    return "arrays of different lengths";
  }
  if (profile.header.stamp.isZero()) return "no stamp";
  constexpr std::uint64_t kMaxCounter = std::uint64_t{1} << 62;  // chosen: no sum overflows
  if (profile.frame_counter > kMaxCounter) return "impossible frame counter";
  return "";
}

ProfileBinder::ProfileBinder(const Settings& settings, const Frames& frames,
                             const Eigen::Isometry3d& fixed_to_base)
    : frames_(frames), fixed_to_base_(fixed_to_base), binder_(settings) {
  scan_cell_common::check(frames);
}

Eigen::Isometry3d pose_from(const std::string& name, const std::vector<double>& numbers) {
  using scan_cell_common::InvalidParameter;
  constexpr const char* kCure = "give x, y, z [m] and a unit quaternion qx, qy, qz, qw";
  if (numbers.size() != 7)
    throw InvalidParameter(name, fmt::format("{} numbers", numbers.size()), kCure);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << numbers[0], numbers[1], numbers[2];
  pose.linear() = scan_cell_common::rotation_from<InvalidParameter>(
      Eigen::Quaterniond(numbers[6], numbers[3], numbers[4], numbers[5]), name, kCure);
  return pose;
}

Run run_from(const scan_cell_msgs::ScanRun& run, const Frames& frames,
             const Eigen::Isometry3d& fixed_to_base) {
  if (!run.straight) return {run.pass_index, std::nullopt};
  ConstantSpeed motion;
  motion.start = in_fixed_frame(run.start, "start", frames, fixed_to_base);
  motion.end = in_fixed_frame(run.end, "end", frames, fixed_to_base);
  motion.speed = run.speed;
  motion.frame_rate = run.rate;
  return {run.pass_index, motion};
}

void ProfileBinder::start_run(const scan_cell_msgs::ScanRun& run) {
  binder_.start_run(run_from(run, frames_, fixed_to_base_));
}

void ProfileBinder::add(const tf2_msgs::TFMessage& transforms) {
  for (const geometry_msgs::TransformStamped& transform : transforms.transforms) {
    if (transform.header.frame_id != frames_.base) continue;
    if (transform.child_frame_id != frames_.flange) continue;
    binder_.add_pose(
        {from_ros(transform.header.stamp), fixed_to_base_ * pose_of(transform.transform)});
  }
}

void ProfileBinder::add(const TriggerEvent& event) {
  binder_.add_pulse({from_ros(event.header.stamp), event.arming, event.count, event.lasers});
}

void ProfileBinder::add(const scan_cell_msgs::PeakProfileConstPtr& profile) {
  const std::size_t number =
      binder_.add_frame({profile->acquisition, profile->frame_counter,
                         from_ros(profile->header.stamp), find_fault(*profile), profile->laser});
  waiting_[number] = profile;
}

std::vector<BoundProfileConstPtr> ProfileBinder::take() {
  std::vector<BoundProfileConstPtr> bound;
  for (const Decision& decision : binder_.take_decisions()) {
    const auto profile = waiting_.find(decision.frame);
    if (decision.match)
      bound.push_back(to_message(*profile->second, *decision.match, frames_.fixed));
    waiting_.erase(profile);
  }
  return bound;
}

scan_cell_msgs::BindingAudit to_message(const Audit& audit, const std::string& scan_id,
                                        const ros::Time& stamp) {
  scan_cell_msgs::BindingAudit message;
  message.header.stamp = stamp;
  message.scan_id = scan_id;
  message.method = static_cast<std::uint8_t>(audit.method);
  message.triggers = audit.triggers;
  message.triggers_missing = audit.triggers_missing;
  message.triggers_refused = audit.triggers_refused;
  message.frames = audit.frames;
  message.poses = audit.poses;
  message.frames_bound = audit.frames_bound;
  message.frames_dropped = audit.frames_dropped;
  message.frames_never_arrived = audit.frames_never_arrived;
  const auto count = [&audit](Rule rule) { return audit.by_rule[static_cast<int>(rule)]; };
  message.one_to_one = count(Rule::kOneToOne);
  message.frames_share_pose = count(Rule::kFramesSharePose);
  message.poses_share_frame = count(Rule::kPosesShareFrame);
  message.interpolated = count(Rule::kInterpolated);
  message.constant_speed = count(Rule::kConstantSpeed);
  message.worst_time_to_pose = audit.worst_time_to_pose;
  message.worst_position_error = audit.worst_position_error;
  message.latency = audit.latency;
  message.latency_doubtful = audit.latency_doubtful;
  for (const Drop& drop : audit.dropped) {
    scan_cell_msgs::DroppedFrame dropped;
    dropped.reason = static_cast<std::uint8_t>(drop.reason);
    dropped.frame_counter = drop.frame_counter;
    dropped.arming = drop.arming;
    dropped.trigger_count = drop.trigger_count;
    dropped.detail = drop.detail;
    message.dropped.push_back(dropped);
  }
  return message;
}

std::string summary(const Audit& audit) {
  std::ostringstream text;
  constexpr double kMilliseconds = 1e3;
  using scan_cell_common::kMillimetres;
  if (audit.method == Method::kConstantSpeed) {
    text << "poses calculated, not measured (error bound "
         << audit.worst_position_error * kMillimetres << " mm): ";
  }
  text << audit.frames_bound << " of " << audit.frames << " frames bound to "
       << audit.triggers - audit.triggers_missing << " pulses and " << audit.poses << " poses";
  std::map<DropReason, std::uint64_t> reasons;
  for (const Drop& drop : audit.dropped)
    ++reasons[drop.reason];
  for (const auto& [reason, count] : reasons)
    text << ", " << count << " " << name(reason);
  if (audit.triggers_missing > 0) {
    text << "; only " << audit.triggers - audit.triggers_missing << " of " << audit.triggers
         << " trigger events arrived";
  }
  if (audit.triggers_refused > 0)
    text << "; " << audit.triggers_refused << " trigger events came twice or out of order";
  if (audit.slips > 0) text << "; the counter slipped " << audit.slips << " times";
  if (std::isfinite(audit.latency)) {
    text << "; frames are stamped " << audit.latency * kMilliseconds << " ms after their pulse";
  }
  if (audit.latency_doubtful) {
    text << "; pulses without a frame at one end of the scan and frames without a pulse at the "
            "other: camera_latency is probably wrong by a pulse interval";
  }
  return text.str();
}

}  // namespace pose_frame_binder
