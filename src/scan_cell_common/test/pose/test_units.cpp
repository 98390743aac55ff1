// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"

using namespace scan_cell_common;

TEST(Units, AreWhatTheStandardsSay) {
  EXPECT_EQ(metres_per("m"), 1);
  EXPECT_EQ(metres_per("mm"), 0.001);
  EXPECT_EQ(metres_per("inch"), 0.0254);
}

TEST(Units, ThatAreNotKnownAreRefusedByName) {
  try {
    metres_per("furlong");
    FAIL() << "taken";
  } catch (const InvalidParameter& error) {
    EXPECT_EQ(error.value(), "'furlong'");
  }
}

TEST(Units, ThatAreOfferedAreAllKnown) {
  for (const std::string& unit : length_units())
    EXPECT_GT(metres_per(unit), 0) << unit;
}
