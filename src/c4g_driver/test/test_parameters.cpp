// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "c4g_driver/tool_check.h"
#include "driver_parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using c4g_driver::DriverParameters;

TEST(DriverParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<DriverParameters>(
      DOCUMENT, "rosrun c4g_driver c4g_driver_node --parameters");
}

TEST(DriverParameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<DriverParameters>(
      {{"most_linear_speed", "max_linear_speed"}, {"most_camera_rate", "max_camera_rate"}});
}

TEST(ToolCheckParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<c4g_driver::ToolCheckParameters>(DOCUMENT,
                                                                       "the table of the check");
}
