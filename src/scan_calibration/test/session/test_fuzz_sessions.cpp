// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "session/session_targets.h"

TEST(SessionReaders, TakeOrRefuseWhateverIsInAFile) {
  for (const auto& target : session_targets()) {
    SCOPED_TRACE(target.name);
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const auto count = scan_cell_common::fuzz(target, 1, 20000);
    EXPECT_GT(count.taken, 200U);
    EXPECT_GT(count.refused, 5000U);
  }
}
