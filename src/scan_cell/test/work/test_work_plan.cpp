// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "work/work_plan.h"

namespace scan_cell {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;
using tool_path_programs::ExportParameters;
using tool_path_programs::WaypointZ;
using tool_paths::ToolPath;

/// Two segments of three waypoints, 0.1 m apart along x, z out of the part.
ToolPath path() {
  ToolPath result;
  result.has_orientation = true;
  for (const double y : {0.0, 0.5}) {
    tool_paths::Segment segment;
    for (const double x : {0.0, 0.1, 0.2}) {
      tool_paths::Waypoint waypoint;
      waypoint.pose.translation() << x, y, 0;
      segment.waypoints.push_back(waypoint);
    }
    result.segments.push_back(segment);
  }
  return result;
}

ExportParameters parameters() {
  ExportParameters result;
  result.waypoint_z = WaypointZ::kOutOfPart;
  result.tool_output = "3";
  return result;
}

WorkPlan plan(std::size_t from = 0, const std::optional<DryRun>& dry = {},
              const std::vector<std::size_t>& in_air = {}) {
  return plan_of(path(), parameters(), in_air, from, dry);
}

/// A text for each waypoint: its number, or - in between.
std::string waypoints(const WorkPlan& plan) {
  std::string text;
  for (const WorkWaypoint& each : plan.waypoints)
    text += each.waypoint ? std::to_string(*each.waypoint) : "-";
  return text;
}

std::string outputs(const WorkPlan& plan) {
  std::string text;
  for (const WorkWaypoint& each : plan.waypoints)
    text += each.outputs == 0 ? "." : each.outputs == 4 ? "3" : "?";
  return text;
}

TEST(WorkPlan, ApproachesFollowsAndRetracts) {
  EXPECT_EQ(waypoints(plan()), "-012--345-");
  EXPECT_TRUE(plan().waypoints[0].tip.translation().isApprox(Eigen::Vector3d(0, 0, 0.05)));
}

TEST(WorkPlan, OutputIsOnWhereTheToolIsInContact) {
  EXPECT_EQ(outputs(plan()), ".33...33..");
  EXPECT_EQ(outputs(plan(0, {}, {0, 5})), "..3...3...");
}

TEST(WorkPlan, GoesOnFromAWaypointWithAnApproachOfItsOwn) {
  EXPECT_EQ(waypoints(plan(1)), "-12--345-");
  EXPECT_EQ(waypoints(plan(4)), "-45-");
  EXPECT_EQ(outputs(plan(4)), ".3..");
  EXPECT_EQ(outputs(plan(4, {}, {4})), "....");
  EXPECT_THROW(plan(6), Refused);
}

TEST(WorkPlan, DryRunIsLiftedSlowAndOff) {
  const WorkPlan real = plan();
  const WorkPlan dry = plan(0, DryRun{0.03, 0.1});
  EXPECT_EQ(outputs(dry), "..........");
  for (std::size_t i = 0; i < real.waypoints.size(); ++i) {
    const Eigen::Vector3d lift =
        dry.waypoints[i].tip.translation() - real.waypoints[i].tip.translation();
    EXPECT_TRUE(lift.isApprox(Eigen::Vector3d(0, 0, 0.03)));
    EXPECT_NEAR(dry.waypoints[i].speed, 0.1 * real.waypoints[i].speed, 1e-12);
  }
}

TEST(WorkPlan, AnOutputThatIsNoNumberIsRefused) {
  for (const char* output : {"doTool", "0", "33", "-1"}) {
    ExportParameters bad = parameters();
    bad.tool_output = output;
    EXPECT_THROW(plan_of(path(), bad, {}, 0, {}), InvalidParameter) << output;
  }
}

TEST(WorkPlan, AnEmptyPathIsRefused) {
  EXPECT_THROW(plan_of(ToolPath(), parameters(), {}, 0, {}), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace scan_cell
