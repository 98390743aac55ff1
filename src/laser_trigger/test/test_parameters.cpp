// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using laser_trigger::Parameters;

TEST(Parameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<Parameters>(
      DOCUMENT, "rosrun laser_trigger laser_trigger_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<Parameters>({{"most_rate", "max_rate"}});
}
