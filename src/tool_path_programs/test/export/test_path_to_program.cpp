// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/path_to_program.h"

namespace tool_path_programs {
namespace {

using tool_paths::ToolPath;

/// Two segments along x, their z axes out of the part (up), with speeds in mm/s.
ToolPath raster() {
  ToolPath path;
  path.name = "raster";
  path.has_orientation = true;
  path.process_names = {"speed"};
  for (const double y : {0.0, 0.01}) {
    tool_paths::Segment segment;
    for (const double x : {0.0, 0.1, 0.2}) {
      tool_paths::Waypoint waypoint;
      waypoint.pose.translation() << x, y, 0.5;
      waypoint.process_values = {20 + 100 * x};
      segment.waypoints.push_back(waypoint);
    }
    path.segments.push_back(segment);
  }
  return path;
}

ExportParameters parameters() {
  ExportParameters result;
  result.waypoint_z = WaypointZ::kOutOfPart;
  result.speed_unit = "mm/s";
  result.tool_output = "5";
  return result;
}

/// One letter per step: j, l for moves, + and - for the output.
std::string kinds(const Program& program) {
  std::string text;
  for (const Step& step : program.steps) {
    if (const Move* move = std::get_if<Move>(&step))
      text += move->kind == MotionKind::kJoint ? 'j' : 'l';
    else
      text += std::get<SetOutput>(step).on ? '+' : '-';
  }
  return text;
}

TEST(PathToProgram, EachSegmentIsApproachedAndLeftWithTheToolOff) {
  const Program program = program_of(raster(), parameters(), {});
  EXPECT_EQ(kinds(program),
            "jl+ll-l"
            "ll+ll-l");
  const auto moves = moves_of(program);
  EXPECT_TRUE(moves[0]->pose.translation().isApprox(Eigen::Vector3d(0, 0, 0.55)));
  EXPECT_TRUE(moves[4]->pose.translation().isApprox(Eigen::Vector3d(0.2, 0, 0.55)));
  EXPECT_TRUE(moves[5]->pose.translation().isApprox(Eigen::Vector3d(0, 0.01, 0.55)));
}

TEST(PathToProgram, ToolPointsIntoThePart) {
  const Program out = program_of(raster(), parameters(), {});
  EXPECT_TRUE(moves_of(out)[1]->pose.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(moves_of(out)[1]->pose.linear().col(0).isApprox(Eigen::Vector3d::UnitX()));
  ExportParameters into = parameters();
  into.waypoint_z = WaypointZ::kIntoPart;
  const Program in = program_of(raster(), into, {});
  EXPECT_TRUE(moves_of(in)[1]->pose.linear().isIdentity());
  EXPECT_TRUE(moves_of(in)[0]->pose.translation().isApprox(Eigen::Vector3d(0, 0, 0.45)));
}

TEST(PathToProgram, WhereTheToolPointsIsNotGuessed) {
  EXPECT_THROW(program_of(raster(), ExportParameters(), {}), scan_cell_common::InvalidParameter);
  ToolPath positions = raster();
  positions.has_orientation = false;
  EXPECT_NO_THROW(program_of(positions, ExportParameters(), {}));
}

TEST(PathToProgram, SpeedsAreThoseOfTheProcessValues) {
  const auto program = program_of(raster(), parameters(), {});
  const auto moves = moves_of(program);
  EXPECT_NEAR(moves[1]->speed, 0.020, 1e-12);
  EXPECT_NEAR(moves[3]->speed, 0.040, 1e-12);
  EXPECT_EQ(moves[4]->speed, ExportParameters().travel_speed);
  ToolPath standing = raster();
  standing.segments[1].waypoints[1].process_values = {0};
  try {
    program_of(standing, parameters(), {});
    FAIL();
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_EQ(error.thing(), "tool path 'raster', waypoint 5");
  }
}

TEST(PathToProgram, OutputIsOnFromTheFirstToTheLastWaypointInContact) {
  const Program program = program_of(raster(), parameters(), {}, {0, 2, 3, 4, 5});
  EXPECT_EQ(kinds(program),
            "jll+-ll"
            "lllll");
  ExportParameters none = parameters();
  none.tool_output.clear();
  EXPECT_EQ(kinds(program_of(raster(), none, {})), "jlllllllll");
}

TEST(PathToProgram, StopsWhereTheOutputChangesAndFliesByElsewhere) {
  const auto program = program_of(raster(), parameters(), {}, {0});
  const auto moves = moves_of(program);
  EXPECT_EQ(moves[1]->zone, 0);
  EXPECT_EQ(moves[2]->zone, 0);
  EXPECT_EQ(moves[3]->zone, 0);
  EXPECT_EQ(moves[7]->zone, ExportParameters().zone);
}

TEST(PathToProgram, ZonesOfNeighboursDoNotOverlap) {
  ExportParameters wide = parameters();
  wide.zone = 1;
  const auto program = program_of(raster(), wide, {}, {0});
  EXPECT_NEAR(moves_of(program)[7]->zone, 0.045, 1e-12) << "neighbours are 0.1 m away";
}

TEST(PathToProgram, AnEmptyPathIsRefused) {
  EXPECT_THROW(program_of(ToolPath(), parameters(), {}), scan_cell_common::UnusableInput);
}

}  // namespace
}  // namespace tool_path_programs
