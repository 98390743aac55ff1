// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Each blow once; `make trials` runs some hundreds.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "running_cell/started_cell.h"
#include "trials/trial.h"

namespace fs = std::filesystem;

using namespace scan_cell_demo;  // NOLINT

namespace {

constexpr std::uint16_t kTapPort = 15420;  // trials.launch
constexpr std::uint16_t kCircuitPort = 5420;
constexpr std::uint16_t kVideePort = 15421;  // trials.launch
// Other programs run beside this test and slow the simulated controller down; make trials uses the
// cell's defaults and the goal. The driver alone would leave the lasers on for more than 0.5 s.
const char* const kUnseenAfter = "unseen_after:=0.2";  // [s]
const char* const kFollowWatch = "follow_watch:=0.2";  // [s]
constexpr TrialLimits kLimits{0.4, 1.0};               // [s]

class Trials : public testing::TestWithParam<Trial> {
 protected:
  static void SetUpTestSuite() {
    fs::create_directories(clouds());
    started_ = std::make_unique<StartedCell>(
        "test_trials",
        std::vector<std::string>{LAUNCH_FILE, kUnseenAfter, kFollowWatch, "folder:=" + clouds()},
        folder());
    tap_ = std::make_unique<LaserTap>(kTapPort, kCircuitPort);
    cell_ = std::make_unique<RunningCell>(ros::NodeHandle());
    bench_ = std::make_unique<TrialBench>(*cell_, *tap_, clouds(), kVideePort, kLimits);
  }
  static void TearDownTestSuite() {
    bench_.reset();
    cell_.reset();
    tap_.reset();
    started_.reset();
    fs::remove_all(folder());
  }
  static std::string folder() {
    return fs::temp_directory_path() / ("trials_" + std::to_string(getpid()));
  }
  static std::string clouds() { return folder() + "/clouds"; }

  static std::unique_ptr<StartedCell> started_;
  static std::unique_ptr<LaserTap> tap_;
  static std::unique_ptr<RunningCell> cell_;
  static std::unique_ptr<TrialBench> bench_;
};

std::unique_ptr<StartedCell> Trials::started_;
std::unique_ptr<LaserTap> Trials::tap_;
std::unique_ptr<RunningCell> Trials::cell_;
std::unique_ptr<TrialBench> Trials::bench_;

/// Each blow at each of its possible moments.
std::vector<Trial> every_trial() {
  std::vector<Trial> trials;
  for (const Blow blow : every_blow()) {
    trials.push_back({blow, Moment::kMidMove, 0.3, 0});
    if (blow == Blow::kStop) {
      trials.push_back({blow, Moment::kMidProgram, 0.6, 0});  // in a later pass
    } else {
      trials.push_back({blow, Moment::kMidScan, 0.3, 0});
    }
  }
  for (const Blow blow : every_blow_in_a_path())
    trials.push_back({blow, Moment::kMidPath, 0.3, 0});
  return trials;
}

}  // namespace

TEST_P(Trials, LasersAndToolGoOffTheRobotStaysAndNothingBeginsAnew) {
  const TrialResult result = bench_->make(GetParam(), name_of(GetParam().moment));
  for (const std::string& failure : result.failures)
    ADD_FAILURE() << failure << "; the cell said: " << result.outcome;
}

INSTANTIATE_TEST_SUITE_P(OfEach, Trials, testing::ValuesIn(every_trial()), [](const auto& trial) {
  std::string name = name_of(trial.param.blow) + " in " + name_of(trial.param.moment);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
});
