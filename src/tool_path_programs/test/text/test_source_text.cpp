// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <stdexcept>

#include "tool_path_programs/source_text.h"

namespace tool_path_programs {
namespace {

TEST(SourceText, EditsChangeNothingElse) {
  const std::vector<SourceFile> files = {{"a.src", "X 1, Y 2 ; Z\r\n"}, {"a.dat", "untouched"}};
  const auto result = edited(files, {{0, 7, 1, "-20.5"}, {0, 2, 1, "10"}});
  EXPECT_EQ(result[0].text, "X 10, Y -20.5 ; Z\r\n");
  EXPECT_EQ(result[1].text, "untouched");
}

TEST(SourceText, SomethingCanBePutIn) {
  EXPECT_EQ(edited({{"a.nc", "G1 X1"}}, {{0, 5, 0, " Y2"}})[0].text, "G1 X1 Y2");
}

TEST(SourceText, EditsThatOverlapAreABug) {
  EXPECT_THROW(edited({{"a.nc", "G1 X1"}}, {{0, 0, 3, ""}, {0, 2, 1, ""}}), std::logic_error);
  EXPECT_THROW(edited({{"a.nc", "G1 X1"}}, {{0, 4, 2, ""}}), std::logic_error);
}

}  // namespace
}  // namespace tool_path_programs
