// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>

#include "record/work_records.h"
#include "scan_cell_common/errors/errors.h"
#include "temporary_folder.h"

using part_recipes::work_records;

namespace {

class WorkRecords : public testing::Test {
 protected:
  std::filesystem::path run() const { return folder_.path() / "20261128T010000Z_frame_1"; }
  void write(const std::string& ending, const std::string& text) const {
    std::ofstream(run().string() + ending) << text;
  }

  part_recipes::TemporaryFolder folder_;
};

TEST_F(WorkRecords, AreThoseInWhichTheRobotPassedAnyWaypoint) {
  write(".work.json", R"({"finished": false, "passed": []})");  // refused
  write(".work_2.log", "the tool did not get that far");
  write(".work_3.json", R"({"finished": true, "passed": [{"waypoint": 0}, {"waypoint": 1}]})");
  write(".work_4.json", R"({"finished": false, "passed": [{"waypoint": 0}]})");
  write(".dry_run.json", R"({"finished": true, "passed": [{"waypoint": 0}]})");
  const auto works = work_records(run(), false);
  ASSERT_EQ(works.size(), 2U);
  EXPECT_TRUE(works[0].finished);
  EXPECT_EQ(works[0].passed, 2U);
  EXPECT_FALSE(works[1].finished);
  EXPECT_EQ(works[1].passed, 1U);
  EXPECT_EQ(work_records(run(), true).size(), 1U);
}

TEST_F(WorkRecords, AreNoneOfARunThatWasNeverWorked) {
  EXPECT_TRUE(work_records(run(), false).empty());
}

TEST_F(WorkRecords, ABrokenOneIsTold) {
  write(".work.json", R"({"finished": tr)");
  EXPECT_THROW(work_records(run(), false), scan_cell_common::UnusableInput);
}

}  // namespace
