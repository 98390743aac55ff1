// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/testing/parameter_test.h"
#include "tool_path_stretcher/stretch_parameters.h"

TEST(StretchParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<tool_path_stretcher::StretchParameters>(
      DOCUMENT, "rosrun tool_path_stretcher tool_path_stretcher_node --parameters");
}
