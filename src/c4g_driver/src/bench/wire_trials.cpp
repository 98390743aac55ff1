// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "trial_setup.h"

namespace c4g_driver {
namespace {

using scan_cell_common::ConnectionError;
using scan_cell_common::Nanoseconds;
using scan_cell_common::Refused;
using scan_cell_sim::Controller;
using SteadyClock = std::chrono::steady_clock;

constexpr double kFaultShare = 0.3;  // of the datagrams; chosen

double seconds_since(SteadyClock::time_point start) {
  return std::chrono::duration<double>(SteadyClock::now() - start).count();
}

/// Compares each delivered pose with the flange's true pose.
class StreamJudge {
 public:
  explicit StreamJudge(const Controller& controller) : controller_(controller) {}

  void operator()(const MeasuredState& state) {
    // Rounding on the wire plus a microsecond of motion.
    constexpr double kPosition = 3e-6, kAngle = 2e-5;  // [m], [rad]
    const Nanoseconds instant = controller_.host_time(state.robot.controller_time / 1000);
    const Eigen::Isometry3d truth = controller_.flange_at(instant);
    const Eigen::Isometry3d& flange = state.robot.flange;
    const double off = (flange.translation() - truth.translation()).norm();
    const double turned = Eigen::AngleAxisd(flange.linear().transpose() * truth.linear()).angle();
    const std::lock_guard<std::mutex> lock(mutex_);
    ++trial_.handed_on;
    trial_.wrong += !(off < kPosition && turned < kAngle);
    trial_.repeated += state.robot.controller_time == newest_;
    trial_.stale += state.robot.controller_time < newest_;
    trial_.backward += state.time <= last_stamp_;
    trial_.late_by.push_back(scan_cell_common::to_seconds(state.time - instant));
    newest_ = std::max(newest_, state.robot.controller_time);
    last_stamp_ = state.time;
  }

  StreamTrial trial() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    StreamTrial result = trial_;
    std::sort(result.late_by.begin(), result.late_by.end());
    return result;
  }

 private:
  const Controller& controller_;
  mutable std::mutex mutex_;
  StreamTrial trial_;
  Nanoseconds newest_ = -1;
  Nanoseconds last_stamp_ = 0;
};

/// Commands with distinguishable effects: each contains its number.
class Commands {
 public:
  explicit Commands(Client& client) : client_(client) {}

  void carry_out(int number) {
    constexpr int kKinds = 50;  // 1 motion, 2 + 2 commands to refuse, 45 to carry out; chosen
    const std::string text = fmt::format("{}", number);
    switch (std::uniform_int_distribution<int>(0, kKinds - 1)(random_)) {
      case 0:
        move(number);
        return;
      case 1:
      case 2:
        client_.set_parameter("model", text);  // it is read-only
        return;
      case 3:
      case 4:
        client_.set_parameter("weather", text);  // it does not exist
        return;
      default:
        client_.set_parameter("user_frame", "[" + text + ", 0, 0, 0, 0, 0]");
    }
  }

  /// The command number in a datagram; none if the client sent the datagram by itself.
  static std::optional<int> number_in(const std::string& datagram) {
    const auto request = nlohmann::json::parse(datagram);
    const std::string command = request["cmd"];
    if (command.compare(0, 4, "MOVE") == 0) return request["camera_fps"].get<int>();
    if (command != "SET_PARAMETER") return std::nullopt;
    const auto& value = request["value"];
    return value.is_array() ? value[0].get<int>() : value.get<int>();
  }

 private:
  /// Moves there along a line and back along half a circle.
  void move(int number) {
    Eigen::Isometry3d via = looking_down(0.005);
    via.translation().x() += 0.005;
    right_ = !right_;  // first: refused commands are not repeated
    if (right_) {
      client_.move_to_pose(looking_down(0.01), number);
    } else {
      client_.move_along_arc(via, looking_down(0), number);
    }
    const Goal goal = client_.wait_for_goal(kPatience);
    if (goal.outcome() == Goal::Outcome::kReached) return;
    throw scan_cell_common::ProtocolError("motion", goal.message(), "it should have arrived");
  }

  Client& client_;
  std::mt19937 random_{1};
  bool right_ = false;
};

enum class Answer { kDone, kRefused, kUnanswered };

Answer answer_to(Commands& commands, int number) {
  try {
    commands.carry_out(number);
    return Answer::kDone;
  } catch (const Refused&) {
    return Answer::kRefused;
  } catch (const ConnectionError&) {
    return Answer::kUnanswered;
  }
}

void judge(Answer answer, int done, CommandTrial& trial) {
  if (done > 1) {
    ++trial.done_twice;
  } else if (answer == Answer::kUnanswered) {
    ++trial.unanswered;
  } else if (answer == Answer::kDone) {
    ++(done == 1 ? trial.done : trial.lost);
  } else {
    ++(done == 0 ? trial.refused : trial.done_in_secret);
  }
}

}  // namespace

scan_cell_sim::ControllerFaults bad_wire() {
  scan_cell_sim::ControllerFaults faults;
  for (auto* const wire : {&faults.to_client, &faults.from_client})
    wire->lost = wire->repeated = wire->delayed = kFaultShare;
  return faults;
}

StreamTrial run_stream_trial(const std::shared_ptr<const RobotModel>& robot, double period,
                             double seconds, const scan_cell_sim::ControllerFaults& faults) {
  scan_cell_sim::ControllerOptions options;
  options.port = 0;
  options.stream_period = period;
  options.faults = faults;
  Controller controller(options);
  StreamJudge judge(controller);
  Client client(options_for(controller, robot),
                [&judge](const MeasuredState& state) { judge(state); });
  wait_for_link(client);
  const auto start = SteadyClock::now();
  int motions = 0;
  while (seconds_since(start) < seconds) {
    client.move_to_pose(looking_down(motions % 2 == 0 ? 0.35 : -0.35), 100);
    client.wait_for_goal(kPatience);
    ++motions;
  }
  StreamTrial trial = judge.trial();
  trial.link = client.link();
  trial.duration = seconds_since(start);
  trial.motions = motions;
  return trial;
}

CommandTrial run_command_trial(const std::shared_ptr<const RobotModel>& robot, int commands,
                               const scan_cell_sim::ControllerFaults& faults) {
  std::mutex mutex;
  std::map<int, int> done;  // count by command number
  scan_cell_sim::ControllerOptions options;
  options.port = 0;
  options.faults = faults;
  options.witness = [&](const scan_cell_sim::TakenUp& taken) {
    const auto number = Commands::number_in(taken.datagram);
    const std::lock_guard<std::mutex> lock(mutex);
    if (number && !taken.refused) ++done[*number];
  };
  Controller controller(options);
  std::vector<Answer> answers;
  CommandTrial trial;
  {
    Client client(options_for(controller, robot), nullptr);
    wait_for_link(client);
    Commands asked(client);
    const auto start = SteadyClock::now();
    for (int number = 0; number < commands; ++number) {
      answers.push_back(answer_to(asked, number));
      if (answers.back() == Answer::kUnanswered) wait_for_link(client);
    }
    trial.duration = seconds_since(start);
  }
  const std::lock_guard<std::mutex> lock(mutex);
  for (int number = 0; number < commands; ++number)
    judge(answers[static_cast<std::size_t>(number)], done[number], trial);
  return trial;
}

}  // namespace c4g_driver
