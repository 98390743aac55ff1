// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using scan_cell_sim::Parameters;

TEST(Parameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<Parameters>(
      DOCUMENT, "rosrun scan_cell_sim scan_cell_sim_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<Parameters>({{"camera/least_period", "camera/min_period"},
                                                {"camera/most_pending", "camera/max_pending"}});
}
