// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell/videe_command.h"
#include "scan_cell_common/errors/errors.h"
#include "videe/videe_line_targets.h"

TEST(VideeLines, AreTakenOrRefusedWhateverAClientSends) {
  for (const auto& target : videe_line_targets()) {
    SCOPED_TRACE(target.name);
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const auto count = scan_cell_common::fuzz(target, 1, 20000);
    EXPECT_GT(count.taken, 500U);
    EXPECT_GT(count.refused, 5000U);
  }
}

TEST(VideeLines, AreRefusedWhereAPoseIsNotSixNumbersOfThisWorld) {
  for (const std::string pose :
       {"1,2,3,4,5,6,", "1,2,3,4,5,6,7", ",1,2,3,4,5", "1,2,3,4,5,", "1e300,2,3,4,5,6",
        "0x10,2,3,4,5,6", "1000001,2,3,4,5,6", "inf,2,3,4,5,6", "1;2;3;4;5;6"}) {
    EXPECT_THROW(scan_cell::pose_from_wire(pose), scan_cell_common::ProtocolError) << pose;
  }
  EXPECT_NO_THROW(scan_cell::pose_from_wire("1000000,-1000000,+3,.5,5e0,-0"));
}
