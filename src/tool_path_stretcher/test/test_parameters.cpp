// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/testing/parameter_test.h"
#include "tool_path_stretcher/stretch_parameters.h"

using tool_path_stretcher::StretchParameters;

TEST(StretchParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<StretchParameters>(
      DOCUMENT, "rosrun tool_path_stretcher tool_path_stretcher_node --parameters");
}

TEST(StretchParameters, RefuseTheirOldNames) {
  scan_cell_common::expect_renamed<StretchParameters>(
      {{"max_path_distance", "max_stand_off"},
       {"max_deformation", "max_deformation_ratio"},
       {"max_displacement", "max_displacement_ratio"}});
}
