// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "path/complaints.h"
#include "tool_paths/path_edits.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_paths;

namespace {

constexpr double kTiny = 1e-12;

/// The tool's z axis points along the path's -x.
Waypoint waypoint(double x, double speed) {
  Waypoint result;
  result.pose.translation().x() = x;
  result.pose.linear() = Eigen::AngleAxisd(-M_PI / 2, Eigen::Vector3d::UnitY()).toRotationMatrix();
  result.process_values = {speed};
  return result;
}

/// Waypoints 0 to 2, then 3 and 4.
ToolPath two_segments() {
  ToolPath path;
  path.has_orientation = true;
  path.process_names = {"speed"};
  path.segments = {{"on", {waypoint(0, 1), waypoint(1, 2), waypoint(2, 4)}},
                   {"off", {waypoint(5, 1), waypoint(6, 1)}}};
  return path;
}

std::vector<double> places_along(const ToolPath& path) {
  std::vector<double> places;
  for (const Eigen::Vector3d& position : positions_of(path))
    places.push_back(position.x());
  return places;
}

std::string complaint_of_edits(const std::vector<PathEdit>& edits,
                               const ToolPath& path = two_segments()) {
  return complaint_of([&] { edited(path, edits); });
}

}  // namespace

TEST(PathEdits, AMoveIsAlongTheAxesOfTheToolOrOfThePath) {
  const EditedPath tool = edited(two_segments(), {MoveEdit{{1, 1}, {0, 0, 0.1}, EditFrame::kTool}});
  EXPECT_NEAR(tool.path.segments[0].waypoints[1].pose.translation().x(), 0.9, kTiny);
  const EditedPath path = edited(two_segments(), {MoveEdit{{1, 3}, {0, 0, 0.1}, EditFrame::kPath}});
  for (const std::size_t i : {0U, 1U, 2U, 3U, 4U})
    EXPECT_NEAR(positions_of(path.path)[i].z(), i >= 1 && i <= 3 ? 0.1 : 0, kTiny);
}

TEST(PathEdits, ATurnKeepsThePlaceAndStaysARotation) {
  const std::vector<PathEdit> turns(1000, TurnEdit{{4, 4}, {1, 0, 0}, 0.5});
  const EditedPath turned = edited(two_segments(), turns);
  const Eigen::Isometry3d before = two_segments().segments[1].waypoints[1].pose;
  const Eigen::Isometry3d& after = turned.path.segments[1].waypoints[1].pose;
  EXPECT_EQ(after.translation(), before.translation());
  const Eigen::Matrix3d expected =
      before.linear() * Eigen::AngleAxisd(500, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_TRUE(after.linear().isApprox(expected, 1e-9));
  const EditedPath about_path =
      edited(two_segments(), {TurnEdit{{4, 4}, {1, 0, 0}, 0.5, EditFrame::kPath}});
  EXPECT_TRUE(about_path.path.segments[1].waypoints[1].pose.linear().isApprox(
      Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()) * before.linear(), kTiny));
}

TEST(PathEdits, WhatIsDeletedIsGoneAndAnEmptySegmentGoesWithIt) {
  EXPECT_EQ(places_along(edited(two_segments(), {DeleteEdit{{1, 1}}}).path),
            (std::vector<double>{0, 2, 5, 6}));
  const ToolPath path = edited(two_segments(), {DeleteEdit{{3, 4}}}).path;
  ASSERT_EQ(path.segments.size(), 1U);
  EXPECT_EQ(path.segments[0].name, "on");
  const ToolPath across = edited(two_segments(), {DeleteEdit{{2, 3}}}).path;
  EXPECT_EQ(across.segments[0].waypoints.size(), 2U);
  EXPECT_EQ(across.segments[1].waypoints.size(), 1U);
}

TEST(PathEdits, AnAddedWaypointLiesOnTheWayToTheNextOfItsSegment) {
  const EditedPath added = edited(two_segments(), {AddEdit{1, 0.25}});
  EXPECT_EQ(places_along(added.path), (std::vector<double>{0, 1, 1.25, 2, 5, 6}));
  EXPECT_DOUBLE_EQ(added.path.segments[0].waypoints[2].process_values[0], 2.5);
  EXPECT_EQ(added.origins[2].first, 1U);
  EXPECT_EQ(added.origins[2].second, 2U);
  EXPECT_TRUE(added.origins[2].edited);
  EXPECT_FALSE(added.origins[1].edited);
  const EditedPath at_end = edited(two_segments(), {AddEdit{2, 0.25}});
  EXPECT_EQ(places_along(at_end.path), (std::vector<double>{0, 1, 2, 2, 5, 6}));
  EXPECT_EQ(at_end.origins[3].second, 2U);
}

TEST(PathEdits, EachEditCountsInThePathThatTheOnesBeforeItLeft) {
  const EditedPath all = edited(two_segments(), {DeleteEdit{{0, 0}}, AddEdit{0, 0.5},
                                                 MoveEdit{{1, 1}, {0, 0, 7}, EditFrame::kPath}});
  EXPECT_EQ(places_along(all.path), (std::vector<double>{1, 1.5, 2, 5, 6}));
  EXPECT_EQ(positions_of(all.path)[1].z(), 7);
  EXPECT_EQ(all.origins[0].first, 1U);
  EXPECT_EQ(all.origins[4].first, 4U);
}

TEST(PathEdits, ValuesAreSetWhereTheyAreAndANewOneForAll) {
  const EditedPath set = edited(two_segments(), {SetEdit{{1, 2}, {{"speed", 9}}}});
  EXPECT_EQ(set.path.segments[0].waypoints[0].process_values[0], 1);
  EXPECT_EQ(set.path.segments[0].waypoints[2].process_values[0], 9);
  const EditedPath more =
      edited(two_segments(), {SetEdit{{0, 4}, {{"air", 0}}}, SetEdit{{3, 3}, {{"air", 1}}}});
  EXPECT_EQ(more.path.process_names, (std::vector<std::string>{"speed", "air"}));
  EXPECT_EQ(more.path.segments[1].waypoints[0].process_values[1], 1);
  EXPECT_EQ(more.path.segments[1].waypoints[1].process_values[1], 0);
}

TEST(PathEdits, WhatThePathHasNoPlaceForIsRefusedWithTheEditsNumber) {
  const PathEdit move = MoveEdit{{0, 0}, {0, 0, 1}};
  EXPECT_TRUE(names(complaint_of_edits({move, DeleteEdit{{5, 5}}}), "edit 2: no waypoint 5"));
  EXPECT_TRUE(
      names(complaint_of_edits({DeleteEdit{{0, 0}}, MoveEdit{{4, 4}, {0, 0, 1}}}), "0 to 3"));
  EXPECT_TRUE(names(complaint_of_edits({DeleteEdit{{0, 4}}}), "deletes all"));
  EXPECT_TRUE(names(complaint_of_edits({DeleteEdit{{3, 2}}}), "3 to 2"));
  EXPECT_TRUE(names(complaint_of_edits({AddEdit{5, 0.5}}), "no waypoint 5"));
  EXPECT_TRUE(
      names(complaint_of_edits({SetEdit{{0, 3}, {{"air", 1}}}}), "set it for 0 to 4 first"));
  ToolPath plain = two_segments();
  plain.has_orientation = false;
  EXPECT_TRUE(names(complaint_of_edits({move}, plain), "frame: path"));
  EXPECT_TRUE(names(complaint_of_edits({TurnEdit{{0, 0}, {0, 0, 1}, 1}}, plain),
                    "path has no orientations"));
  EXPECT_TRUE(names(complaint_of_edits({MoveEdit{{0, 0}, {0, 0, INFINITY}}}), "not finite"));
}

TEST(PathEdits, AreMarkedInThePathAndStayMarked) {
  const ToolPath once = marked(edited(two_segments(), {MoveEdit{{1, 1}, {0, 0, 1}}}));
  EXPECT_EQ(once.process_names.back(), kEditedValue);
  const ToolPath twice = marked(edited(once, {DeleteEdit{{0, 0}}, AddEdit{2, 0.5}}));
  EXPECT_EQ(twice.process_names.size(), 2U);
  std::vector<double> marks;
  for (const Segment& segment : twice.segments)
    for (const Waypoint& each : segment.waypoints)
      marks.push_back(each.process_values[1]);
  EXPECT_EQ(marks, (std::vector<double>{1, 0, 0, 1, 0}));
}

TEST(PathEdits, AFileOfThemHasAPlaceForTheMark) {
  const ToolPathFile csv = parse_tool_path_csv("z_mm,x_mm,y_mm,speed\n1,2,3,4\n5,6,7,8\n", "p.csv");
  const ToolPath path = marked(edited(csv.path, {MoveEdit{{1, 1}, {1, 0, 0}, EditFrame::kPath}}));
  EXPECT_EQ(tool_path_to_csv(path, layout_for(path, csv.layout)),
            "z_mm,x_mm,y_mm,speed,edited\n1,2,3,4,0\n5,1006,7,8,1\n");
  const ToolPathFile yaml = parse_tool_path_yaml(
      "note: kept\npaths: [{poses: [{position: {x: 1, y: 2, z: 3}}]}]\n", "p.yaml");
  const ToolPath same = marked(edited(yaml.path, {AddEdit{0, 0}}));
  const std::string text = tool_path_to_yaml(same, layout_for(same, yaml.layout));
  const ToolPath back = parse_tool_path_yaml(text, "p.yaml").path;
  EXPECT_EQ(waypoint_count(back), 2U);
  EXPECT_EQ(back.segments[0].waypoints[1].process_values, (std::vector<double>{1}));
}
