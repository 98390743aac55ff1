// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/csv_reader.h"

using scan_cell_common::CsvReader;

namespace {

std::string complaint_about_pose(const std::string& line) {
  CsvReader table(line, "poses.csv");
  table.next();
  try {
    table.expect_fields(7);
    table.pose(0);
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(CsvReader, LeavesOutCommentsEmptyLinesAndBlanks) {
  CsvReader table("\xef\xbb\xbf# head\n\n a , b\r\n#x\n1,,3", "t");
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.fields(), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_EQ(table.line(), 3U);
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.fields(), (std::vector<std::string_view>{"1", "", "3"}));
  EXPECT_EQ(table.line(), 5U);
  EXPECT_FALSE(table.next());
}

TEST(CsvReader, RefusesAPoseWithTheLineAndTheCure) {
  EXPECT_EQ(complaint_about_pose("1,2,3,0,0,0,1"), "nothing");
  EXPECT_EQ(complaint_about_pose("1,2,3,0,0,1"),
            "poses.csv: line 1: 6 values; give 7, as in the header");
  EXPECT_EQ(complaint_about_pose("1,2,x,0,0,0,1"), "poses.csv: line 1: 'x'; give a number");
  EXPECT_EQ(complaint_about_pose("1,2,3,0,0,0,inf"), "poses.csv: line 1: 'inf'; give a number");
  EXPECT_NE(complaint_about_pose("1,2,3,0,0,0.5,0.5").find("quaternion of length 0.7"),
            std::string::npos);
  EXPECT_NE(complaint_about_pose("1,2,3,10,175,-90,0").find("angles in degrees"),
            std::string::npos);
  EXPECT_NE(complaint_about_pose("1200,2,300,0,0,0,1").find("looks like millimetres"),
            std::string::npos);
}
