// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using pose_frame_binder::Parameters;

TEST(Parameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<Parameters>(
      DOCUMENT, "rosrun pose_frame_binder pose_frame_binder_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<Parameters>({{"most_pose_gap", "max_pose_gap"},
                                                {"most_acceleration", "max_acceleration"},
                                                {"most_speed", "max_speed"},
                                                {"most_poses", "max_poses"},
                                                {"most_pending_frames", "max_pending_frames"},
                                                {"lookup/most_clients", "lookup/max_clients"}});
}
