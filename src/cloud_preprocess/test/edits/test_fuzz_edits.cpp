// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "edits/edits_targets.h"

TEST(EditsReader, TakesOrRefusesWhateverIsInAFile) {
  for (const auto& target : edits_targets()) {
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const auto count = scan_cell_common::fuzz(target, 1, 20000);
    EXPECT_GT(count.taken, 500U);
    EXPECT_GT(count.refused, 5000U);
  }
}
