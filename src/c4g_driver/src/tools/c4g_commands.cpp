// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "c4g_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/interrupts.h"

namespace c4g_driver {
namespace {

using scan_cell_common::CatchInterrupts;
using scan_cell_common::ConnectionError;
using scan_cell_common::Refused;
using Clock = std::chrono::steady_clock;

constexpr double kGlance = 0.05;  // [s] between two checks for an interrupt; chosen

Clock::time_point in(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Prints six values, rounded to the controller's accuracy, without -0.
/// @param lengths how many are lengths [mm]; the others are angles [deg]
void print_six(const char* what, const WireSix& values, int lengths, const char* meaning) {
  std::printf("%-15s", what);
  for (int i = 0; i < 6; ++i) {
    const int digits = i < lengths ? 3 : 4;
    const double scale = std::pow(10, digits);
    std::printf(" %.*f", digits, std::round(values[i] * scale) / scale + 0.0);
  }
  std::printf("  %s\n", meaning);
}

void print_pose(const char* what, const RobotState& robot) {
  print_six(what, to_wire(robot.flange), 3, "x y z [mm] A E R [deg]");
}

/// Checks a pose as the controller does, which does not wrap angles into their range;
/// c4g_protocol.md.
Eigen::Isometry3d checked_pose(const WireSix& pose, const std::string& name) {
  constexpr std::array<double, 3> kLeast = {-180, 0, -180};
  for (std::size_t i = 0; i < kLeast.size(); ++i) {
    const double angle = pose[3 + i];
    if (angle >= kLeast[i] && angle <= 180) continue;
    throw Refused(fmt::format("{} {}", name, "AER"[i]), fmt::format("{:g} deg", angle),
                  fmt::format("give one from {} to 180 deg", std::lround(kLeast[i])));
  }
  return pose_from_wire(pose);
}

RobotState state_of(const Client& client) {
  const auto state = client.latest();
  if (!state) throw ConnectionError(client.name(), client.link().message, "try again");
  return state->robot;
}

void refuse_if_interrupted() {
  if (CatchInterrupts::interrupted()) {
    throw Refused("c4g", "interrupted before it began", "give the command again");
  }
}

MeasuredState wait_until_it_stands(Client& client) {
  constexpr double kPatience = 5;  // [s] to brake from any speed; chosen
  const Clock::time_point deadline = in(kPatience);
  while (true) {
    try {
      return client.static_pose();
    } catch (const Refused&) {
      if (Clock::now() > deadline) throw;
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(kGlance));
  }
}

Goal wait_for_end(Client& client) {
  bool stopping = false;
  while (true) {
    const Goal goal = client.wait_for_goal(kGlance);
    if (!goal.underway()) return goal;
    if (stopping || !CatchInterrupts::interrupted()) continue;
    client.stop();
    stopping = true;
  }
}

void follow(Client& client) {
  std::printf("moving; Ctrl-C stops the robot\n");
  std::fflush(stdout);
  const Goal goal = wait_for_end(client);
  if (goal.outcome() == Goal::Outcome::kLinkLost) {
    throw ConnectionError("motion", goal.message(), "see c4g status");
  }
  const MeasuredState end = wait_until_it_stands(client);
  print_pose(goal.outcome() == Goal::Outcome::kReached ? "reached" : "stands at", end.robot);
  if (goal.outcome() == Goal::Outcome::kReached) return;
  if (CatchInterrupts::interrupted()) {
    throw Refused("motion", "stopped by a signal", "it does not go on; give the command again");
  }
  throw Refused("motion", goal.message(), "see c4g status");
}

}  // namespace

void wait_for_link(const Client& client, double patience) {
  const Clock::time_point deadline = in(patience);
  while (!client.wait_for_link(kGlance)) {
    refuse_if_interrupted();
    if (Clock::now() < deadline) continue;
    throw ConnectionError(client.name(), client.link().message,
                          "check the cable, the address and the controller's program; it takes one "
                          "client at a time, so end the driver");
  }
}

void show_state(const Client& client) {
  const RobotState robot = state_of(client);
  std::printf("%s\n", client.name().c_str());
  std::printf("%-15s %s\n", "mode", name_of(robot.mode));
  std::printf("%-15s %s\n", "emergency stop", robot.e_stop ? "pressed" : "released");
  std::printf("%-15s %s\n", "drives", robot.drives ? "on" : "off");
  std::printf("%-15s %s\n", "takes motions", takes_motions(robot) ? "yes" : "no");
  std::printf("%-15s %s%s%s\n", "latest motion", name_of(robot.status), robot.error ? ": " : "",
              robot.error ? robot.error->text.c_str() : "");
  std::printf("%-15s %g %%\n", "override", robot.override);
  std::printf("%-15s %g mm/s\n", "linear speed", 1e3 * robot.linear_speed);
  if (robot.alarms.empty()) std::printf("%-15s none\n", "alarms");
  for (const ControllerError& alarm : robot.alarms)
    std::printf("%-15s %d %s\n", "alarm", alarm.code, alarm.text.c_str());
  print_pose("pose", robot);
  print_six("joints", to_wire(robot.joints), 0, "J1 .. J6 [deg]");
}

void show_alarms(const Client& client) {
  const RobotState robot = state_of(client);
  if (robot.alarms.empty()) std::printf("no alarms\n");
  for (const ControllerError& alarm : robot.alarms)
    std::printf("%d %s\n", alarm.code, alarm.text.c_str());
}

void move_to_pose(Client& client, const WireSix& pose, double camera_rate) {
  refuse_if_interrupted();
  client.move_to_pose(checked_pose(pose, "target"), camera_rate);
  follow(client);
}

void move_along_arc(Client& client, const WireSix& via, const WireSix& pose, double camera_rate) {
  refuse_if_interrupted();
  client.move_along_arc(checked_pose(via, "via"), checked_pose(pose, "target"), camera_rate);
  follow(client);
}

void move_to_joints(Client& client, const WireSix& joints, double camera_rate) {
  refuse_if_interrupted();
  const Joints target = joints_from_wire(joints);
  client.move_to_joints({target.begin(), target.end()}, camera_rate);
  follow(client);
}

void stop(Client& client) {
  client.stop();
  print_pose("stands at", wait_until_it_stands(client).robot);
}

void show_parameter(Client& client, const std::string& name) {
  std::printf("%s\n", client.get_parameter(name).c_str());
}

void write_parameter(Client& client, const std::string& name, const std::string& value) {
  const bool word = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || c == '_';
  });
  const bool is_json = nlohmann::json::accept(value);
  client.set_parameter(name, word && !is_json ? nlohmann::json(value).dump() : value);
  show_parameter(client, name);
}

}  // namespace c4g_driver
