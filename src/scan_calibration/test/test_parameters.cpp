// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "calibrated_frames_parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

TEST(CalibratedFramesParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<scan_calibration::CalibratedFramesParameters>(
      DOCUMENT, "rosrun scan_calibration calibrated_frames_node --parameters");
}
