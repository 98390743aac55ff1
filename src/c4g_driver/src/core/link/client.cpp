// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/client.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "link/link.h"
#include "link/path_loader.h"
#include "robot/motion_check.h"
#include "scan_cell_common/errors/errors.h"
#include "wire/parameter_values.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;

ClientOptions checked(ClientOptions options) {
  if (!options.robot) {
    throw InvalidParameter("robot description", "none", "give the model of the robot");
  }
  options.limits = narrowed(options.limits, *options.robot);
  const double shortest = std::min({options.link_timeout, options.poll_period, options.follow_watch,
                                    options.reconnect_period, options.clock_window});
  if (!(shortest > 0) || options.tries < 1) {
    throw InvalidParameter("C4G client's times and tries",
                           fmt::format("{} s, {}", shortest, options.tries),
                           "give times above 0 and at least one try");
  }
  return options;
}

/// @param motion that check_goal() takes
Goal::Target target_of(const Motion& motion) {
  if (motion.kind != Motion::Kind::kToJoints) return motion.flange;
  return Joints(Eigen::Map<const Joints>(motion.joints.data()));
}

/// @param motion that check_goal() takes
Request request_of(const Motion& motion) {
  switch (motion.kind) {
    case Motion::Kind::kToPose:
      return MoveCartesian{motion.flange, motion.camera_rate};
    case Motion::Kind::kAlongArc:
      return MoveCircular{motion.via, motion.flange, motion.camera_rate};
    case Motion::Kind::kToJoints:
      break;
  }
  return MoveJoint{std::get<Joints>(target_of(motion)), motion.camera_rate};
}

}  // namespace

Client::Client(const ClientOptions& options, Listener listener)
    : options_(checked(options)), link_(std::make_unique<Link>(options_, std::move(listener))) {}

Client::~Client() = default;

void Client::move_to_pose(const Eigen::Isometry3d& flange, double camera_rate) {
  Motion motion;
  motion.flange = flange;
  motion.camera_rate = camera_rate;
  move(motion);
}

void Client::move_along_arc(const Eigen::Isometry3d& via, const Eigen::Isometry3d& flange,
                            double camera_rate) {
  Motion motion;
  motion.kind = Motion::Kind::kAlongArc;
  motion.via = via;
  motion.flange = flange;
  motion.camera_rate = camera_rate;
  move(motion);
}

void Client::move_to_joints(const std::vector<double>& joints, double camera_rate) {
  Motion motion;
  motion.kind = Motion::Kind::kToJoints;
  motion.joints = joints;
  motion.camera_rate = camera_rate;
  move(motion);
}

template <class Choose>
void Client::begin(bool in_joints, const Choose& choose) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  if (goal().underway()) throw Refused("motion", "another is under way", "stop it first");
  MotionSettings settings;
  if (!in_joints) settings = settings_in_force();
  const RobotState from = standing();
  settings.linear_speed = from.linear_speed;
  settings.override = from.override;
  const auto [motion, end] =
      choose(MotionCheck(*options_.robot, options_.limits, from, settings), from);
  const Request request = request_of(motion);
  const Link::Start start{target_of(motion), end.max_override};
  link_->request(request, &start);
}

void Client::move(const Motion& motion) {
  check_goal(motion, *options_.robot, options_.limits);
  begin(motion.kind == Motion::Kind::kToJoints, [&](const MotionCheck& check, const RobotState&) {
    return std::pair(motion, check.run(motion));
  });
}

void Client::jog(const Jog& jog) {
  constexpr double kLeast = 1.0 / 256;  // 2 mm, or a third of a degree; chosen
  begin(jog.kind == Jog::Kind::kJoint, [&](const MotionCheck& check, const RobotState& from) {
    for (double share = 1;; share /= 2) {
      const Motion motion = jog_motion(from, jog, share);
      try {
        check_goal(motion, *options_.robot, options_.limits);
        return std::pair(motion, check.run(motion));
      } catch (const Refused&) {
        if (share <= kLeast) throw;
      }
    }
  });
}

ToolCheck Client::check_path(const ToolMotion& motion, std::size_t from, const RobotState& state) {
  if (from + 2 > motion.waypoints.size()) {
    throw scan_cell_common::UnusableInput("waypoint to begin with",
                                          fmt::format("{} of {}", from, motion.waypoints.size()),
                                          "give any but the last");
  }
  ToolMotion rest = motion;
  rest.waypoints.erase(rest.waypoints.begin(),
                       rest.waypoints.begin() + static_cast<std::ptrdiff_t>(from));
  ToolCheckParameters parameters = options_.tool_check;
  parameters.rotational_speed = rotational_speed_of(get_parameter("rotational_speed"));
  return check_tool_motion(*options_.robot, options_.limits, state, rest, parameters);
}

ToolCheck Client::check(const ToolMotion& motion, std::size_t from,
                        const std::vector<double>& joints) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  RobotState state = current();
  if (!joints.empty()) {
    state.joints = check_joints(joints, options_.limits);
    state.flange = options_.robot->flange_at(state.joints);
  }
  return check_path(motion, from, state);
}

void Client::follow(const ToolMotion& motion, std::size_t from,
                    const std::function<bool()>& go_on) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  if (goal().underway()) throw Refused("path", "another motion is under way", "stop it first");
  const ToolCheck check = check_path(motion, from, standing());
  if (!check.possible()) {
    const ToolFault& fault = check.faults.front();
    throw Refused(fault.thing, fault.value, fault.cure);
  }
  if (!check.stands_there) {
    throw Refused("path",
                  check.as_it_stands.empty()
                      ? fmt::format("the robot is not at waypoint {}", from)
                      : "not from the robot's present posture: " + check.as_it_stands,
                  "first move it there, to the joints that check_follow gives");
  }
  FollowPath request = load_path(*link_, motion, ++paths_, from, go_on);
  request.watch = options_.follow_watch;
  const Link::Start start{motion.waypoints.back().tip * motion.flange_to_tip.inverse(), 100};
  link_->request(request, &start);
}

PlanCheck Client::check(const std::vector<PlannedMotion>& plan, bool linear,
                        const std::vector<double>& joints) {
  constexpr double kBraking = 0.5;  // [s] more than a stopped robot takes to stand; chosen
  if (joints.empty()) wait_for_goal(kBraking);
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  MotionSettings settings = settings_in_force();
  RobotState from = joints.empty() ? standing() : current();
  settings.linear_speed = from.linear_speed;
  settings.override = from.override;
  if (linear) settings.in_joints = settings.euler = false;
  if (!joints.empty()) {
    from.joints = check_joints(joints, options_.limits);
    from.flange = options_.robot->flange_at(from.joints);
  }
  return check_plan(*options_.robot, options_.limits, from, settings, plan);
}

RobotState Client::current() const {
  const auto state = latest();
  if (!link().up || !state) throw ConnectionError(name(), link().message, kCheckLink);
  return state->robot;
}

RobotState Client::standing() const {
  const RobotState state = current();
  if (state.status == MotionStatus::kMoving) {
    throw Refused("motion", "the robot is moving", "wait until it stands still");
  }
  return state;
}

MotionSettings Client::settings_in_force() {
  MotionSettings settings;
  settings.in_joints = goes_in_joints(get_parameter("motion_type"));
  settings.euler = turns_by_euler_angles(get_parameter("interpolation"));
  settings.rotational_speed = rotational_speed_of(get_parameter("rotational_speed"));
  return settings;
}

SpeedLimit Client::speed_limit() const {
  const auto state = latest();
  return c4g_driver::speed_limit(options_.limits, state ? &state->robot : nullptr);
}

void Client::stop() {
  link_->request(Stop{});
}

void Client::set_override(double percent) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  check_override(percent, link_->max_override());
  link_->request(SetOverride{percent});
}

void Client::set_linear_speed(double speed) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  check_linear_speed(speed, speed_limit());
  link_->request(SetLinearSpeed{speed});
}

void Client::set_drives(bool on) {
  link_->request(SetDrives{on});
}

void Client::reset_alarms() {
  link_->request(ResetAlarms{});
}

std::string Client::get_parameter(const std::string& name) {
  return link_->request(GetParameter{name}).value;
}

void Client::set_parameter(const std::string& name, const std::string& json) {
  check_size("SET_PARAMETER", name.size() + json.size());  // before it is parsed, however deep
  const SetParameter set{name, json};
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  if (const auto percent = override_of(set)) check_override(*percent, link_->max_override());
  if (const auto speed = linear_speed_of(set)) check_linear_speed(*speed, speed_limit());
  link_->request(set);
}

MeasuredState Client::static_pose() {
  link_->request(GetStaticPose{});
  const auto state = latest();
  if (!state) throw ConnectionError(name(), "sent no pose", kCheckLink);
  if (state->robot.status == MotionStatus::kMoving) {
    throw Refused("static pose", "the robot is moving", "wait until it stands still, or stop it");
  }
  return *state;
}

const std::string& Client::name() const {
  return link_->name();
}

Goal Client::goal() const {
  return link_->goal();
}

Goal Client::wait_for_goal(double timeout) const {
  return link_->wait_for_goal(timeout);
}

bool Client::wait_for_link(double timeout) const {
  return link_->wait_until_up(timeout);
}

std::optional<MeasuredState> Client::latest() const {
  return link_->latest();
}

LinkReport Client::link() const {
  return link_->report();
}

}  // namespace c4g_driver
