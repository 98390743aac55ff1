// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Position stream and commands over a bad network, compared with what the controller really did.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "follow_trials.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/tools/tool_main.h"
#include "wire_trials.h"

namespace {

using namespace c4g_driver;

double percentile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 0;
  return ascending[static_cast<std::size_t>(share * static_cast<double>(ascending.size() - 1))];
}

void count(const char* what, std::uint64_t value, const char* goal) {
  std::printf("  %-52s %10llu   %s\n", what, static_cast<unsigned long long>(value), goal);
}

bool stream(const std::shared_ptr<const RobotModel>& robot, double seconds) {
  constexpr double kPeriod = 0.002;     // [s] the shortest of the controller
  constexpr double kMicrosecond = 1e6;  // in a second
  const StreamTrial trial = run_stream_trial(robot, kPeriod, seconds, bad_wire());
  const SequenceCounts& wire = trial.link.stream;
  std::printf(
      "position stream of 500 a second for %.0f s and %d motions; lost, repeated, overtaken: 30 %% "
      "each, in both directions\n",
      trial.duration, trial.motions);
  count("sent", wire.received - wire.repeated + wire.lost, "");
  count("lost on the way", wire.lost, "");
  count("came again", wire.repeated, "");
  count("came after a later one", wire.reordered, "");
  count("poses delivered", trial.handed_on, "");
  count("of these wrong (not the flange's true pose)", trial.wrong, "goal 0");
  count("stale (older than one before)", trial.stale, "goal 0");
  count("repeated", trial.repeated, "goal 0");
  count("stamped no later than the one before", trial.backward, "goal 0");
  count("times the link was lost", trial.link.losses, "");
  std::printf("  stamp after the true instant [us]: median %.1f, p1 %.1f, p99 %.1f\n",
              kMicrosecond * percentile(trial.late_by, 0.5),
              kMicrosecond * percentile(trial.late_by, 0.01),
              kMicrosecond * percentile(trial.late_by, 0.99));
  return trial.handed_on > 0 && trial.wrong + trial.stale + trial.repeated + trial.backward == 0;
}

bool commands(const std::shared_ptr<const RobotModel>& robot, int number) {
  scan_cell_sim::ControllerFaults faults;
  faults.to_client.lost = faults.from_client.lost = 0.3;  // chosen
  const CommandTrial trial = run_command_trial(robot, number, faults);
  std::printf("%d commands, 30 %% lost each way, in %.0f s\n", number, trial.duration);
  count("reported as done, and done once", trial.done, "");
  count("refused with a reason, and not done", trial.refused, "");
  count("link lost meanwhile, and reported", trial.unanswered, "");
  count("done twice or more", trial.done_twice, "goal 0");
  count("reported as done, and not done", trial.lost, "goal 0");
  count("reported as refused, and done", trial.done_in_secret, "goal 0");
  return trial.done > 0 && trial.done_twice + trial.lost + trial.done_in_secret == 0;
}

/// Prints each reason once.
void tell_reasons(const std::vector<std::string>& reasons) {
  std::map<std::string, int> counts;
  for (const std::string& reason : reasons)
    ++counts[reason];
  for (const auto& [reason, times] : counts)
    std::printf("    %d times: %s\n", times, reason.c_str());
}

bool paths(const std::shared_ptr<const RobotModel>& robot, int number) {
  const FollowTrial trial = run_follow_trial(robot, number, bad_wire());
  std::printf(
      "%d paths of the tool; lost, repeated, overtaken: 30 %% each, in both directions, in %.0f "
      "s\n",
      number, trial.duration);
  count("followed, each waypoint once and in order", trial.followed, "");
  count("waypoints of these", trial.waypoints, "");
  count("refused with a reason, and nothing moved", trial.refused, "");
  count("ended early with a reason", trial.ended_early, "");
  tell_reasons(trial.reasons);
  count("begun twice or more", trial.twice, "goal 0");
  count("out of order", trial.out_of_order, "goal 0");
  count("reported otherwise than it was", trial.in_secret, "goal 0");
  tell_reasons(trial.faults);
  return trial.followed > 0 && trial.twice + trial.out_of_order + trial.in_secret == 0;
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 120;
  int number = 10000;
  int number_of_paths = 100;  // two seconds each, mostly motion
  CLI::App app("The driver's client against the emulated controller over a bad wire");
  app.add_option("--seconds", seconds, "of the position stream")->capture_default_str();
  app.add_option("--commands", number, "")->check(CLI::Range(1, 10000))->capture_default_str();
  app.add_option("--paths", number_of_paths, "of the tool")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  return scan_cell_common::tool_main("bench_c4g_wire", app, argc, argv, [&] {
    const auto robot = std::make_shared<const RobotModel>(scan_cell_common::read_file(URDF_FILE),
                                                          "base_link", "flange");
    const bool streamed = stream(robot, seconds);
    std::fflush(stdout);
    const bool commanded = commands(robot, number);
    std::fflush(stdout);
    const bool followed = paths(robot, number_of_paths);
    return streamed && commanded && followed ? 0 : scan_cell_common::kUnusable;
  });
}
