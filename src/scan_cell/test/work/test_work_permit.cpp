// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "work/work_permit.h"

namespace scan_cell {
namespace {

using scan_cell_common::Refused;

class Permit : public testing::Test {
 protected:
  Permit() {
    report_.proven_path = "aa";
    report_.scanner = "bb";
    report_.cell = "cc";
    report_.scanned = 1000;
  }
  void TearDown() override { std::filesystem::remove(file_); }

  /// The refusal; empty: the path may run.
  std::string refusal(double now = 1500, bool dry = false) const {
    try {
      check_permit(report_, cell_, rules_, DryRuns(file_), dry, now);
      return "";
    } catch (const Refused& error) {
      return error.thing();
    }
  }

  const std::string file_ = testing::TempDir() + "dry_runs_" + std::to_string(getpid()) + ".json";
  tool_path_programs::AcceptedReport report_;
  CalibrationNow cell_{"bb", "cc"};
  WorkRules rules_;
};

TEST_F(Permit, ARealRunNeedsADryRunOfThisPathInThisCell) {
  EXPECT_EQ(refusal(), "work");
  EXPECT_EQ(refusal(1500, true), "");
  DryRuns(file_).add("other", "cc", 1);
  DryRuns(file_).add("aa", "other", 1);
  EXPECT_EQ(refusal(), "work");
  DryRuns(file_).add("aa", "cc", 1);
  EXPECT_EQ(refusal(), "");
  EXPECT_TRUE(DryRuns(file_).has("other", "cc")) << "nothing is forgotten";
}

TEST_F(Permit, ADryRunIsNotAskedForWhereTheRulesSaySo) {
  rules_.dry_run_first = false;
  EXPECT_EQ(refusal(), "");
}

TEST_F(Permit, AnotherCalibrationThanTheScansIsRefused) {
  rules_.dry_run_first = false;
  cell_.scanner = "xx";
  EXPECT_EQ(refusal(), "scanner model");
  cell_ = {"bb", "xx"};
  EXPECT_EQ(refusal(), "cell file");
  cell_ = {"bb", ""};
  EXPECT_EQ(refusal(), "cell file");
  cell_ = {"bb", "cc"};
  report_.cell.clear();
  EXPECT_EQ(refusal(), "report");
}

TEST_F(Permit, AnOldScanIsRefused) {
  rules_.dry_run_first = false;
  EXPECT_EQ(refusal(1000 + 3600), "");
  EXPECT_EQ(refusal(1000 + 3601), "scan");
  EXPECT_EQ(refusal(990), "scan") << "from the future: a clock is wrong";
  report_.scanned.reset();
  EXPECT_EQ(refusal(), "report");
  rules_.max_age = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(), "");
}

TEST_F(Permit, ADamagedRecordOfDryRunsIsNotTakenForAnEmptyOne) {
  scan_cell_common::save_text(file_, "{\"dry_runs\": [{\"proven_path\": 1}]}");
  EXPECT_THROW(refusal(), scan_cell_common::UnusableInput);
  EXPECT_THROW(DryRuns(file_).add("aa", "cc", 1), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace scan_cell
