// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "parameters/parameters.h"
#include "replay_parameters.h"
#include "scan_cell_common/testing/parameter_test.h"
#include "videe/videe_parameters.h"

using scan_cell_common::expect_documented;

TEST(Parameters, AreAllInTheDocuments) {
  expect_documented<scan_cell::Parameters>(DOCUMENTS "scan_cell.md",
                                           "rosrun scan_cell scan_cell_node --parameters");
  expect_documented<scan_cell::ReplayParameters>(DOCUMENTS "scan_cell.md",
                                                 "rosrun scan_cell replay --parameters");
  expect_documented<scan_cell::VideeParameters>(DOCUMENTS "videe_protocol.md",
                                                "rosrun scan_cell videe_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<scan_cell::Parameters>(
      {{"most_speed", "max_speed"},
       {"most_rate", "max_rate"},
       {"most_length", "max_length"},
       {"calibration/most_reprojection_rms_px", "calibration/max_reprojection_rms_px"},
       {"calibration/most_laser_plane_rms_mm", "calibration/max_laser_plane_rms_mm"},
       {"calibration/most_board_scatter_mm", "calibration/max_board_scatter_mm"},
       {"calibration/most_point_deviation_mm", "calibration/max_point_deviation_mm"}});
}
