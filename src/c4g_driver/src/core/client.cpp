// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_driver/client.h"

#include <algorithm>

#include "c4g_driver/kinematics.h"
#include "scan_cell_common/errors.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Error;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Nanoseconds;
using scan_cell_common::ProtocolError;
using scan_cell_common::Refused;

constexpr const char* kCheckLink = "check the cable, the address and the controller's program";

const ClientOptions& checked(const ClientOptions& options) {
  const double shortest = std::min(
      {options.link_timeout, options.poll_period, options.reconnect_period, options.clock_window});
  if (!(shortest > 0) || options.tries < 1) {
    throw InvalidParameter("C4G client's times and tries",
                           std::to_string(shortest) + " s, " + std::to_string(options.tries),
                           "give times above 0 and at least one try");
  }
  return options;
}

/// True for the errors that say that there is no session (any more); docs/c4g_protocol.md.
bool ends_the_session(const ControllerError& error) {
  constexpr int kOtherVersion = 2, kNoSuchSession = 3, kAnotherClient = 4;
  return error.code == kOtherVersion || error.code == kNoSuchSession ||
         error.code == kAnotherClient;
}

std::uint64_t microseconds_now() {
  using std::chrono::system_clock;
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(system_clock::now().time_since_epoch())
          .count());
}

}  // namespace

Client::Client(const ClientOptions& options, const Listener& listener)
    : options_(checked(options)),
      name_("controller " + options.address + ":" + std::to_string(options.port)),
      listener_(listener),
      socket_(options.address, options.port, kMostDatagramBytes),
      poses_(options.clock_window, options.link_timeout) {
  receiver_ = std::thread([this] { receive(); });
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
    if (link().up) request(Close{});
  } catch (const Error&) {
    // the controller stops the motion of a silent client
  }
  deaf_ = true;
  receiver_.join();
}

void Client::move_to_pose(const Eigen::Isometry3d& flange, double camera_rate) {
  check_flange(flange, options_.limits);
  check_camera_rate(camera_rate, options_.limits);
  const auto state = latest();
  if (state) check_speed_in_force(state->robot.linear_speed, options_.limits);
  const Goal::Target target = flange;
  request(MoveCartesian{flange, camera_rate}, &target);
}

void Client::move_to_joints(const std::vector<double>& joints, double camera_rate) {
  const Joints checked_joints = check_joints(joints, options_.limits);
  check_workspace(flange_at(checked_joints), options_.limits);
  check_camera_rate(camera_rate, options_.limits);
  const Goal::Target target = checked_joints;
  request(MoveJoint{checked_joints, camera_rate}, &target);
}

void Client::stop() {
  request(Stop{});
}

void Client::set_override(double percent) {
  check_override(percent);
  request(SetOverride{percent});
}

void Client::set_linear_speed(double speed) {
  check_linear_speed(speed, options_.limits);
  request(SetLinearSpeed{speed});
}

std::string Client::get_parameter(const std::string& name) {
  return request(GetParameter{name}).value;
}

void Client::set_parameter(const std::string& name, const std::string& json) {
  const SetParameter set{name, json};
  if (const auto percent = override_of(set)) check_override(*percent);
  if (const auto speed = linear_speed_of(set)) check_linear_speed(*speed, options_.limits);
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

std::optional<MeasuredState> Client::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return poses_.latest();
}

LinkReport Client::link() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  LinkReport report;
  report.up = up_;
  report.message = up_ ? "" : why_down_;
  report.losses = losses_;
  report.stream = stream_.counts();
  report.dropped = poses_.counts();
  report.malformed = malformed_;
  report.last_malformed = last_malformed_;
  report.foreign = socket_.foreign();
  report.overlong = socket_.overlong();
  return report;
}

Acknowledgement Client::request(const Request& request, const Goal::Target* target) {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  std::string datagram;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!up_) throw ConnectionError(name_, why_down_, kCheckLink);
    if (target != nullptr && goal_.underway()) {
      throw Refused(name_of(request), "a motion is under way", "stop it first");
    }
    datagram = build(request, session_, ++seq_);
    answer_.reset();
    if (target != nullptr) goal_ = Goal(seq_, *target, options_.arrival);
  }
  const auto answer = exchange(datagram);
  if (!answer || (answer->error && ends_the_session(*answer->error))) {
    const std::string reason = answer ? "dropped the session: " + answer->error->text
                                      : "does not answer " + name_of(request);
    lose(reason);
    throw ConnectionError(name_, reason, kCheckLink);
  }
  if (answer->error) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (target != nullptr) goal_ = Goal();
    throw Refused(name_of(request), "refused by the controller, " + answer->error->text,
                  "see error " + std::to_string(answer->error->code) + " in docs/c4g_protocol.md");
  }
  return *answer;
}

std::optional<Acknowledgement> Client::exchange(const std::string& datagram) {
  const std::chrono::duration<double> patience(options_.link_timeout / options_.tries);
  for (int i = 0; i < options_.tries; ++i) {
    socket_.send(datagram);
    std::unique_lock<std::mutex> lock(mutex_);
    if (changed_.wait_for(lock, patience, [this] { return answer_.has_value(); })) return answer_;
  }
  return std::nullopt;
}

void Client::connect() {
  const std::lock_guard<std::mutex> serial(request_mutex_);
  std::string datagram;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    session_ = std::max(session_ + 1, microseconds_now());
    seq_ = 1;
    answer_.reset();
    stream_.restart();
    poses_.restart(Clock::now());
    datagram = build(Open{}, session_, seq_);
  }
  const auto answer = exchange(datagram);
  const std::lock_guard<std::mutex> lock(mutex_);
  up_ = answer && !answer->error;
  if (!up_) why_down_ = answer ? answer->error->text : "does not answer";
}

void Client::lose(const std::string& reason) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    up_ = false;
    why_down_ = reason;
    ++losses_;
    goal_.end(Goal::Outcome::LinkLost, name_ + " " + reason);
  }
  changed_.notify_all();
}

void Client::keep() {
  while (true) {
    if (link().up) {
      poll();
    } else {
      connect();
    }
    std::unique_lock<std::mutex> lock(mutex_);
    const std::chrono::duration<double> pause(up_ ? options_.poll_period
                                                  : options_.reconnect_period);
    if (changed_.wait_for(lock, pause, [this] { return ending_; })) return;
  }
}

void Client::poll() {
  try {
    request(GetStaticPose{});
  } catch (const ConnectionError&) {
    return;  // a lost link is seen in the next round
  } catch (const Error&) {
    // what the controller complains of is in its state
  }
  // All that came before the answer is taken in by now, so a delay of this process is not blamed on
  // the controller.
  bool stale = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stale = poses_.stale(Clock::now());
  }
  if (stale) lose("sends no fresh poses");
}

void Client::receive() {
  constexpr double kGlance = 0.05;  // [s]
  while (!deaf_) {
    const auto received = socket_.receive(kGlance);
    if (!received) continue;
    try {
      handle(*received);
    } catch (const ProtocolError& error) {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++malformed_;
      last_malformed_ = error.what();
    }
  }
}

void Client::handle(const UdpSocket::Received& received) {
  const Reply reply = parse(received.datagram);
  std::visit([&](const auto& kind) { handle(kind, received.time); }, reply);
}

void Client::handle(const StreamedState& streamed, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (streamed.session != session_) return;
    if (stream_.take(streamed.number) != SequenceMonitor::Verdict::Next) return;
  }
  take(streamed.session, streamed.robot, arrival, PoseFeed::Source::Stream);
}

void Client::handle(const Acknowledgement& acknowledgement, Nanoseconds arrival) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;
  }
  if (acknowledgement.robot) {
    take(acknowledgement.session, *acknowledgement.robot, arrival,
         PoseFeed::Source::Acknowledgement);
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!awaited(acknowledgement)) return;  // another session began meanwhile
    answer_ = acknowledgement;
  }
  changed_.notify_all();
}

bool Client::awaited(const Acknowledgement& acknowledgement) const {
  return acknowledgement.session == session_ && acknowledgement.seq == seq_ && !answer_;
}

void Client::take(std::uint64_t session, const RobotState& robot, Nanoseconds arrival,
                  PoseFeed::Source source) {
  MeasuredState measured;
  PoseFeed::Verdict verdict = PoseFeed::Verdict::Overtaken;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (session != session_) return;
    verdict = poses_.take(robot, arrival, source, Clock::now());
    if (verdict == PoseFeed::Verdict::Overtaken) return;
    measured = *poses_.latest();
    goal_.update(robot);
  }
  changed_.notify_all();
  if (verdict == PoseFeed::Verdict::HandOn && listener_) listener_(measured);
}

}  // namespace c4g_driver
