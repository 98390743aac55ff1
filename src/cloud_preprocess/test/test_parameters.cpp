// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cloud_preprocess/clean.h"
#include "scan_cell_common/testing/parameter_test.h"

using cloud_preprocess::CleanParameters;

TEST(CleanParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<CleanParameters>(
      DOCUMENT, "rosrun cloud_preprocess clean_cloud --parameters");
}

TEST(CleanParameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<CleanParameters>(
      {{"floor/least_share", "floor/min_share"},
       {"floor/most_below", "floor/max_below"},
       {"isolate/least_points", "isolate/min_points"}});
}
