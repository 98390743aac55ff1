// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"

TEST(Error, SaysTheThingTheValueAndTheCure) {
  const scan_cell_common::InvalidParameter error("rate", "-5", "give one above 0");
  EXPECT_STREQ(error.what(), "rate: -5; give one above 0");
  EXPECT_EQ(error.thing(), "rate");
  EXPECT_EQ(error.value(), "-5");
  EXPECT_EQ(error.cure(), "give one above 0");
}
