// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "pass_planner/candidates.h"
#include "scan_cell_common/testing/parameter_test.h"

TEST(PassPlannerParameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<pass_planner::SightParameters>(
      DOCUMENT, "rosrun pass_planner seen_waypoints --help");
  scan_cell_common::expect_documented<pass_planner::PlanParameters>(
      DOCUMENT, "rosrun pass_planner plan_passes --help");
}
