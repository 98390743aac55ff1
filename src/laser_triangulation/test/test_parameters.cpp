// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "parameters.h"
#include "scan_cell_common/testing/parameter_test.h"

using laser_triangulation::Parameters;

TEST(Parameters, AreAllInTheDocument) {
  scan_cell_common::expect_documented<Parameters>(
      DOCUMENT, "rosrun laser_triangulation laser_triangulation_node --parameters");
}

TEST(Parameters, AreRefusedByTheirOldNamesWithTheNewOnes) {
  scan_cell_common::expect_renamed<Parameters>({{"least_width", "min_width"},
                                                {"most_width", "max_width"},
                                                {"least_intensity", "min_intensity"},
                                                {"most_intensity", "max_intensity"},
                                                {"least_range", "min_range"},
                                                {"most_range", "max_range"},
                                                {"most_points", "max_points"},
                                                {"most_message_points", "max_message_points"}});
}
