// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "verdict/placement_checks.h"

using namespace tool_path_stretcher;

namespace {

/// Ten waypoints on a scanned surface. Two have an expected error of 6 mm along it, and so has a
/// third, in the air.
Placement placed() {
  Placement placement;
  placement.quality.resize(10);
  placement.strangers.resize(10);
  for (WaypointQuality& each : placement.quality) {
    each.measured = true;
    each.support = 20;
    each.expected_error_tangential = 0.001;
    each.expected_error_orientation = 0.001;
  }
  for (const std::size_t i : {3U, 5U, 7U})
    placement.quality[i].expected_error_tangential = 0.006;
  placement.quality[5].in_air = true;
  return placement;
}

PlacementLimits limits(bool edges_are_known, double spacing = 0.002) {
  return {spacing, 0.2, edges_are_known};
}

}  // namespace

TEST(PositionUncertain, NamesTheWaypointsThatMayHaveSlidAndNoneInTheAir) {
  try {
    check_placement(placed(), limits(true), {});
    FAIL() << "accepted";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(to_string(refusal.verdict.reason), "position_uncertain");
    EXPECT_EQ(refusal.verdict.waypoints, (std::vector<std::size_t>{3, 7}));
    EXPECT_NE(refusal.verdict.message.find("6 mm"), std::string::npos) << refusal.verdict.message;
    EXPECT_NE(refusal.verdict.message.find("max_position_error (5 mm)"), std::string::npos)
        << refusal.verdict.message;
  }
}

TEST(PositionUncertain, IsNoPathThatThePersonSaidToBeKnownNoBetter) {
  StretchParameters parameters;
  parameters.max_position_error = 0.007;
  EXPECT_NO_THROW(check_placement(placed(), limits(true), parameters));
  parameters = {};
  parameters.prior.pose = PosePrior();
  parameters.prior.pose->distance = 0.007;
  EXPECT_NO_THROW(check_placement(placed(), limits(true), parameters));
}

TEST(PositionUncertain, IsNoPathOnSurfacesThatCannotShowMore) {
  EXPECT_NO_THROW(check_placement(placed(), limits(true, 0.035), {}));
}

TEST(PositionUncertain, IsNoPathWhoseReferenceDoesNotTellEdgesFromWhereItsScanEnded) {
  EXPECT_NO_THROW(check_placement(placed(), limits(false), {}));
}
