// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "jogger.h"

#include <fmt/format.h>
#include <scan_cell_msgs/JogState.h>

#include <utility>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {

using scan_cell_common::Error;
using Message = scan_cell_msgs::Jog;

namespace {

constexpr double kLook = 0.02;  // [s] between two checks of the wish; chosen

Jog::Kind kind_of(const Message& message) {
  switch (message.kind) {
    case Message::JOINT:
      return Jog::Kind::kJoint;
    case Message::BASE:
      return Jog::Kind::kBase;
    case Message::FLANGE:
      return Jog::Kind::kFlange;
    default:
      throw scan_cell_common::Refused("kind", fmt::format("{}", message.kind),
                                      "give a constant of scan_cell_msgs/Jog");
  }
}

}  // namespace

Jogger::Jogger(ros::NodeHandle node, Client& client, double silence, double max_override)
    : client_(client),
      silence_(silence),
      max_override_(max_override),
      state_(node.advertise<scan_cell_msgs::JogState>("jog_state", 10, true)) {
  tell(false, "");
  ros::NodeHandle hearing(node), working(node);
  hearing.setCallbackQueue(&heard_queue_);
  working.setCallbackQueue(&work_queue_);
  subscriber_ = hearing.subscribe("jog", 10, &Jogger::hear, this);
  timer_ = working.createSteadyTimer(ros::WallDuration(kLook),
                                     [this](const ros::SteadyTimerEvent&) { work(); });
  hearing_.start();
  working_.start();
}

Jogger::~Jogger() {
  hearing_.stop();
  working_.stop();
  stop();
}

void Jogger::hear(const Message& message) {
  std::optional<Wish> wish;
  std::string refusal;
  try {
    if (message.direction != 0) {
      if (!(message.override > 0 && message.override <= max_override_))
        throw scan_cell_common::Refused(
            "override", fmt::format("{:g} %", message.override),
            fmt::format("give one above 0 and up to {:g} % (max_jog_override)", max_override_));
      wish = Wish{{kind_of(message), message.axis, message.direction}, message.override};
    }
  } catch (const Error& error) {
    refusal = error.what();
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  wish_ = wish;
  was_up_ = was_up_ || message.direction == 0;
  refusal_ = refusal;
  heard_ = ros::SteadyTime::now();
}

/// The motion wanted at this moment; none after a silence.
std::optional<Jogger::Wish> Jogger::wish() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if ((ros::SteadyTime::now() - heard_).toSec() > silence_) return std::nullopt;
  return wish_;
}

/// After a silence, earlier messages no longer count: the button may be held without a message
/// arriving.
bool Jogger::is_silent() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return (ros::SteadyTime::now() - heard_).toSec() > silence_;
}

bool Jogger::take_up() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(was_up_, false);
}

void Jogger::work() {
  const bool up = take_up();  // before the wish: a release must precede it
  const auto wanted = wish();
  if (is_silent()) let_go_first_ = true;
  if (under_way_ && !client_.goal().underway()) end(wanted.has_value());
  if (under_way_) {
    if (!wanted || !(wanted->jog == *under_way_)) stop();
    return;
  }
  if (up) let_go_first_ = false;
  if (wanted) {
    if (!let_go_first_) begin(*wanted);
    return;
  }
  if (const std::string refusal = take_refusal(); !refusal.empty()) tell(false, refusal);
}

/// At the end of one piece of the way the next one may begin; after a stop by others it may not.
void Jogger::end(bool held) {
  const Goal goal = client_.goal();
  const bool as_wanted = goal.outcome() == Goal::Outcome::kReached ||
                         (stopping_ && goal.outcome() == Goal::Outcome::kStopped);
  under_way_.reset();
  stopping_ = false;
  let_go_first_ = let_go_first_ || (held && !as_wanted);
  restore_speed();
  tell(false, as_wanted ? "" : goal.message());
}

std::string Jogger::take_refusal() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(refusal_, {});
}

void Jogger::begin(const Wish& wish) {
  try {
    slow_down(wish.override);
    client_.jog(wish.jog);
    under_way_ = wish.jog;
    tell(true, "");
  } catch (const Error& error) {
    restore_speed();
    let_go_first_ = true;
    tell(false, error.what());
  }
}

/// Lowers the override, and never raises it.
void Jogger::slow_down(double percent) {
  const auto state = client_.latest();
  if (!state || state->robot.override <= percent) return;
  if (client_.goal().underway()) return;  // another client's goal: the motion will be refused
  client_.set_override(percent);
  override_before_ = state->robot.override;
}

void Jogger::restore_speed() {
  if (!override_before_) return;
  const double before = *override_before_;
  override_before_.reset();
  try {
    client_.set_override(before);
  } catch (const Error& error) {
    ROS_WARN("The override stays lowered: %s; set it to %g %%", error.what(), before);
  }
}

void Jogger::stop() {
  if (!under_way_ || stopping_) return;
  try {
    client_.stop();
    stopping_ = true;
  } catch (const Error& error) {
    ROS_ERROR_THROTTLE(1, "%s", error.what());  // a lost link ends the motion; else tried again
  }
}

void Jogger::tell(bool moving, const std::string& message) {
  scan_cell_msgs::JogState state;
  state.moving = static_cast<unsigned char>(moving);
  state.message = message;
  state_.publish(state);
}

}  // namespace c4g_driver
