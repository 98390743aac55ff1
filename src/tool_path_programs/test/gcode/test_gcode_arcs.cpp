// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "gcode_reader/gcode_arcs.h"

namespace tool_path_programs {
namespace {

/// A quarter of the circle of 10 mm about (0, 0), from X to Y.
GcodeArc quarter() {
  GcodeArc arc;
  arc.from = {10, 0, 3};
  arc.to = {0, 10, 3};
  arc.centre_from_start = Eigen::Vector3d(-10, 0, 0);
  return arc;
}

const double kRoot = 10 * M_SQRT1_2;

TEST(GcodeArcs, GoBothWaysRound) {
  GcodeArc arc = quarter();
  EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(kRoot, kRoot, 3)).norm(), 1e-12);
  arc.clockwise = true;
  EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(-kRoot, -kRoot, 3)).norm(), 1e-12);
}

TEST(GcodeArcs, ByRadiusTheShorterWayOrTheLonger) {
  for (const bool clockwise : {false, true}) {
    GcodeArc arc = quarter();
    arc.clockwise = clockwise;
    arc.radius = 10;  // the shorter way: about (0, 0), or about (10, 10)
    const double near = clockwise ? 10 - kRoot : kRoot;
    EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(near, near, 3)).norm(), 1e-9);
    arc.radius = -10;  // the longer way: about (10, 10), or about (0, 0)
    const double far = clockwise ? -kRoot : 10 + kRoot;
    EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(far, far, 3)).norm(), 1e-9);
  }
}

// G18: the plane is Z X, seen against Y; from X to Z is clockwise there.
TEST(GcodeArcs, LieInTheirPlane) {
  GcodeArc arc;
  arc.normal = 1;
  arc.clockwise = true;
  arc.from = {10, 3, 0};
  arc.to = {0, 3, 10};
  arc.centre_from_start = Eigen::Vector3d(-10, 0, 0);
  EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(kRoot, 3, kRoot)).norm(), 1e-12);
  arc.clockwise = false;
  EXPECT_LT((*middle_of(arc) - Eigen::Vector3d(-kRoot, 3, -kRoot)).norm(), 1e-12);
}

TEST(GcodeArcs, WholeCirclesHelicesAndArcsThatAreNoneAreNone) {
  GcodeArc whole = quarter();
  whole.to = whole.from;
  EXPECT_FALSE(middle_of(whole));
  GcodeArc helix = quarter();
  helix.to.z() = 4;
  EXPECT_FALSE(middle_of(helix));
  GcodeArc off = quarter();
  off.to.y() = 10.1;
  EXPECT_FALSE(middle_of(off));
  GcodeArc without = quarter();
  without.centre_from_start.reset();
  EXPECT_FALSE(middle_of(without));
  without.radius = 5;
  EXPECT_FALSE(middle_of(without));
}

}  // namespace
}  // namespace tool_path_programs
