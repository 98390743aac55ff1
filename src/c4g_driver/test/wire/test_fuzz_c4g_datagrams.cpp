// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "wire/c4g_datagram_targets.h"

TEST(C4gDatagrams, AreTakenOrRefusedWhateverComes) {
  for (const auto& target : c4g_datagram_targets()) {
    SCOPED_TRACE(target.name);
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const auto count = scan_cell_common::fuzz(target, 1, 10000);
    EXPECT_GT(count.taken, target.name == "raw" ? 0U : 300U);  // few changes keep the seal
    EXPECT_GT(count.refused, 2500U);
  }
}
