// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/client.h"

#include <algorithm>

#include "scan_cell_common/errors.h"
#include "wire/parameter_values.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;

constexpr const char* kCheckLink = "check the cable, the address and the controller's program";

ClientOptions checked(ClientOptions options) {
  if (!options.robot) {
    throw InvalidParameter("robot description", "none", "give the model of the robot");
  }
  options.limits = narrowed(options.limits, *options.robot);
  const double shortest = std::min(
      {options.link_timeout, options.poll_period, options.reconnect_period, options.clock_window});
  if (!(shortest > 0) || options.tries < 1) {
    throw InvalidParameter("C4G client's times and tries",
                           std::to_string(shortest) + " s, " + std::to_string(options.tries),
                           "give times above 0 and at least one try");
  }
  return options;
}

/// True for the errors after which only a new session helps; c4g_protocol.md.
bool ends_the_session(const ControllerError& error) {
  constexpr int kOtherVersion = 2, kNoSuchSession = 3, kAnotherClient = 4, kOutOfTurn = 18;
  return error.code == kOtherVersion || error.code == kNoSuchSession ||
         error.code == kAnotherClient || error.code == kOutOfTurn;
}

}  // namespace

Client::Client(const ClientOptions& options, const Listener& listener)
    : options_(checked(options)),
      name_("controller " + options.address + ":" + std::to_string(options.port)),
      listener_(listener),
      socket_(options.local_address, options.address, options.port, kMostDatagramBytes),
      poses_(options.clock_window, options.link_timeout) {
  start_receiving();
  keeper_ = std::thread([this] { keep(); });
}

Client::~Client() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  keeper_.join();
  try {
    if (goal().underway()) request(Stop{});
    if (up()) request(Close{});
  } catch (const Error&) {
    // the controller stops the motion of a silent client
  }
  deaf_ = true;
  receiver_.join();
}

void Client::move_to_pose(const Eigen::Isometry3d& flange, double camera_rate) {
  check_flange(flange, options_.limits);
  check_camera_rate(camera_rate, options_.limits);
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  const Start start{flange, motion_check(true).to_pose(flange)};
  request(MoveCartesian{flange, camera_rate}, &start);
}

void Client::move_to_joints(const std::vector<double>& joints, double camera_rate) {
  const Joints target = check_joints(joints, options_.limits);
  check_workspace(options_.robot->flange_at(target), options_.limits);
  check_camera_rate(camera_rate, options_.limits);
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  const Start start{target, motion_check(false).to_joints(target)};
  request(MoveJoint{target, camera_rate}, &start);
}

/// From where the robot stands, with what is set on the controller.
MotionCheck Client::motion_check(bool along_line) {
  if (goal().underway()) throw Refused("motion", "another is under way", "stop it first");
  MotionSettings settings;
  if (along_line) settings = settings_in_force();
  const auto state = latest();
  if (!link().up || !state) throw ConnectionError(name_, link().message, kCheckLink);
  if (state->robot.status == MotionStatus::Moving) {
    throw Refused("motion", "the robot moves", "wait until it stands");
  }
  settings.linear_speed = state->robot.linear_speed;
  settings.override = state->robot.override;
  return {*options_.robot, options_.limits, state->robot, settings};
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

double Client::most_override() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_.underway() ? most_override_ : 100;
}

void Client::stop() {
  request(Stop{});
}

void Client::set_override(double percent) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  check_override(percent, most_override());
  request(SetOverride{percent});
}

void Client::set_linear_speed(double speed) {
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  check_linear_speed(speed, speed_limit());
  request(SetLinearSpeed{speed});
}

void Client::set_drives(bool on) {
  request(SetDrives{on});
}

void Client::reset_alarms() {
  request(ResetAlarms{});
}

std::string Client::get_parameter(const std::string& name) {
  return request(GetParameter{name}).value;
}

void Client::set_parameter(const std::string& name, const std::string& json) {
  check_size("SET_PARAMETER", name.size() + json.size());  // before it is parsed, however deep
  const SetParameter set{name, json};
  const std::lock_guard<std::mutex> settled(settings_mutex_);
  if (const auto percent = override_of(set)) check_override(*percent, most_override());
  if (const auto speed = linear_speed_of(set)) check_linear_speed(*speed, speed_limit());
  request(set);
}

MeasuredState Client::static_pose() {
  request(GetStaticPose{});
  const auto state = latest();
  if (!state) throw ConnectionError(name_, "told no pose", kCheckLink);
  if (state->robot.status == MotionStatus::Moving) {
    throw Refused("static pose", "the robot moves", "wait until it stands, or stop it");
  }
  return *state;
}

Goal Client::goal() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return goal_;
}

Goal Client::wait_for_goal(double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(timeout),
                    [this] { return !goal_.underway(); });
  return goal_;
}

bool Client::wait_for_link(double timeout) const {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(timeout), [this] { return up_; });
}

std::optional<MeasuredState> Client::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return poses_.latest();
}

bool Client::up() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return up_;
}

LinkReport Client::link() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  LinkReport report;
  report.up = up_;
  report.message = why_down_;
  report.losses = losses_;
  report.stream = stream_.counts();
  report.attempts = attempts_;
  report.dropped = poses_.counts();
  report.clock = poses_.clock();
  report.late = late_;
  report.round_trip = round_trip_;
  report.hand_on = hand_on_;
  report.malformed = malformed_;
  report.last_malformed = last_malformed_;
  report.foreign = socket_.foreign();
  report.overlong = socket_.overlong();
  return report;
}

Acknowledgement Client::request(const Request& request, const Start* start) {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  std::string datagram;
  std::uint64_t malformed = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!up_) throw ConnectionError(name_, why_down_, kCheckLink);
    if (start != nullptr && goal_.underway()) {
      throw Refused(name_of(request), "another motion is under way", "stop it first");
    }
    datagram = build(request, session_, seq_ + 1);
    ++seq_;
    malformed = malformed_;
    answer_.reset();
    if (start != nullptr) {
      goal_ = Goal(seq_, start->target, options_.arrival);
      most_override_ = start->most_override;
    }
  }
  const auto answer = exchange(datagram);
  if (!answer || (answer->error && ends_the_session(*answer->error))) {
    const std::string reason =
        answer ? std::string("dropped the session: ") + answer->error->text.c_str()
               : why_no_answer(request, malformed);
    lose(reason);
    throw ConnectionError(name_, reason, kCheckLink);
  }
  if (answer->error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (start != nullptr) goal_ = Goal();
    throw Refused(name_of(request),
                  std::string("refused by the controller, ") + answer->error->text.c_str(),
                  "see error " + std::to_string(answer->error->code) + " in c4g_protocol.md");
  }
  return *answer;
}

/// @param malformed how many datagrams were so before the request
std::string Client::why_no_answer(const Request& request, std::uint64_t malformed) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (malformed_ > malformed) return "sends what the protocol does not allow: " + last_malformed_;
  return "does not answer " + name_of(request);
}

std::optional<Acknowledgement> Client::exchange(const std::string& datagram) {
  const std::chrono::duration<double> patience(options_.link_timeout / options_.tries);
  for (int i = 0; i < options_.tries; ++i) {
    const Clock::time_point sent = Clock::now();
    socket_.send(datagram);
    std::unique_lock<std::mutex> lock(mutex_);
    if (!changed_.wait_for(lock, patience, [this] { return answer_.has_value(); })) continue;
    // Karn's rule (1987): the answer to a retry may be that to an earlier try
    if (i == 0) round_trip_.add(std::chrono::nanoseconds(Clock::now() - sent).count());
    return answer_;
  }
  return std::nullopt;
}

}  // namespace c4g_driver
