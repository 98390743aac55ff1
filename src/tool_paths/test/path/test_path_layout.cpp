// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "path/complaints.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

using namespace tool_paths;
using scan_cell_common::UnusableInput;

namespace {

const char* const kNoether = R"(- dwell_time: 0
  header:
    frame_id: "part one"
    stamp: {sec: 1596044229, nsec: 179712191}
  process_type: {val: "\x00"}
  tool_offset:
    position: {x: 0, y: 0, z: 0}
    orientation: {x: 1, y: 0, z: 0, w: 6.1e-17}
  paths:
    - poses:
        - orientation: {z: 0, w: 1, x: 0, y: 0}
          position: {x: 0.5, y: -0.25, z: 0.125}
        - position: {x: 1, y: 2, z: 3}
          orientation: {x: 0, y: 0, z: 1, w: 0}
      header: {seq: 4, frame_id: "007"}
    - header: {seq: 3}
      poses:
        - position: {x: 7, y: 8, z: 9}
          orientation: {x: 0, y: 0, z: 0, w: 1}
)";

/// As rostopic echo writes a nav_msgs/Path, message for message.
const char* const kEchoed = R"(header:
  seq: 1
  frame_id: "world"
poses:
  -
    header: {seq: 5, frame_id: "part"}
    pose:
      position:
        x: 1.0
        y: 2.0
        z: 3.0
      orientation: {x: 0.0, y: 0.0, z: 0.0, w: 1.0}
---
header:
  seq: 2
  frame_id: "world"
poses:
  -
    header: {seq: 6, frame_id: "part"}
    pose:
      position: {x: 4.0, y: 5.0, z: 6.0}
      orientation: {x: 0.0, y: 0.0, z: 0.0, w: 1.0}
  -
    header: {seq: 7, frame_id: "part"}
    pose:
      position: {x: 7.0, y: 8.0, z: 9.0}
      orientation: {x: 0.0, y: 0.0, z: 0.0, w: 1.0}
---
)";

ToolPathFile read(const std::string& text) {
  return parse_tool_path_yaml(text, "path");
}

std::string layout_complaint(const std::string& text) {
  return complaint_of([&] { read(text); });
}

ToolPath lifted(ToolPath path) {
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation().z() += 100;
  }
  return path;
}

/// Lists each leaf of a document with the path to it.
void list_leaves(const YAML::Node& node, const std::string& way,
                 std::vector<std::pair<std::string, std::string>>& leaves) {
  if (node.IsMap()) {
    for (const auto& entry : node)
      list_leaves(entry.second, way + "/" + entry.first.Scalar(), leaves);
  } else if (node.IsSequence()) {
    for (std::size_t i = 0; i < node.size(); ++i)
      list_leaves(node[i], way + "/" + std::to_string(i), leaves);
  } else {
    leaves.emplace_back(way, node.Scalar());
  }
}

/// Expects that only the z of the positions [m] differ, by the 100 of lifted().
void expect_only_lifted(const std::string& before, const std::string& after) {
  const std::vector<YAML::Node> from = YAML::LoadAll(before);
  const std::vector<YAML::Node> to = YAML::LoadAll(after);
  std::vector<std::pair<std::string, std::string>> a, b;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!from[i].IsNull()) list_leaves(from[i], std::to_string(i), a);
  }
  for (std::size_t i = 0; i < to.size(); ++i)
    list_leaves(to[i], std::to_string(i), b);
  ASSERT_EQ(a.size(), b.size()) << after;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].first, b[i].first);
    const bool is_z = names(a[i].first, "poses") && names(a[i].first, "position/z");
    if (is_z) {
      EXPECT_EQ(std::stod(a[i].second) + 100, std::stod(b[i].second)) << a[i].first;
    } else {
      EXPECT_EQ(a[i].second, b[i].second) << a[i].first;
    }
  }
}

}  // namespace

TEST(YamlShape, StaysAsItCame) {
  for (const char* const text : {kNoether, kEchoed}) {
    const ToolPathFile file = read(text);
    expect_only_lifted(text, tool_path_to_yaml(lifted(file.path), file.layout));
  }
}

TEST(YamlShape, KeepsTextsThatLookLikeNumbersInQuotes) {
  const ToolPathFile file = read(kNoether);
  const std::string written = tool_path_to_yaml(file.path, file.layout);
  EXPECT_TRUE(names(written, "\"007\"")) << written;
  EXPECT_TRUE(names(written, "\"part one\"")) << written;
}

TEST(YamlShape, NamesWhatStandsBesideThePath) {
  const std::vector<std::string> expected = {"dwell_time", "header", "process_type", "tool_offset"};
  EXPECT_EQ(read(kNoether).layout.kept, expected);
}

TEST(YamlShape, OfFlatPosesStaysFlat) {
  const std::string text =
      "- [{x: 1, y: 2, z: 3, qw: 1, qx: 0, qy: 0, qz: 0, speed: 5, note: slow},\n"
      "   {x: 4, y: 5, z: 6, qw: 1, qx: 0, qy: 0, qz: 0, speed: 7, note: fast}]\n";
  const ToolPathFile file = read(text);
  EXPECT_EQ(file.path.process_names, std::vector<std::string>{"speed"});
  EXPECT_EQ(file.path.segments[0].waypoints[1].process_values, std::vector<double>{7});
  EXPECT_EQ(file.layout.kept, std::vector<std::string>{"note"});
  const YAML::Node written = YAML::Load(tool_path_to_yaml(lifted(file.path), file.layout));
  EXPECT_EQ(written[0][1]["z"].Scalar(), "106");
  EXPECT_EQ(written[0][1]["qw"].Scalar(), "1");
  EXPECT_EQ(written[0][1]["speed"].Scalar(), "7");
  EXPECT_EQ(written[0][1]["note"].Scalar(), "fast");
}

TEST(YamlShape, TakesMoreWaypointsThanTheFileHad) {
  ToolPathFile file = read(kNoether);
  file.path = resampled(file.path, 0.1);
  const std::string written = tool_path_to_yaml(file.path, file.layout);
  const ToolPath again = read(written).path;
  ASSERT_EQ(again.segments.size(), file.path.segments.size());
  for (std::size_t s = 0; s < again.segments.size(); ++s) {
    ASSERT_EQ(again.segments[s].waypoints.size(), file.path.segments[s].waypoints.size());
    for (std::size_t w = 0; w < again.segments[s].waypoints.size(); ++w) {
      EXPECT_EQ(again.segments[s].waypoints[w].pose.translation(),
                file.path.segments[s].waypoints[w].pose.translation());
    }
  }
  EXPECT_EQ(YAML::Load(written)[0]["header"]["frame_id"].Scalar(), "part one");
}

TEST(YamlDocuments, AreAllRead) {
  const ToolPathFile file = read(kEchoed);
  ASSERT_EQ(file.path.segments.size(), 2U);
  EXPECT_EQ(waypoint_count(file.path), 3U);
  EXPECT_EQ(file.path.segments[1].waypoints[1].pose.translation(), Eigen::Vector3d(7, 8, 9));
}

TEST(YamlDocuments, OfAPoseEachAreOneSegment) {
  const std::string text =
      "header: {seq: 1}\npose: {position: {x: 1, y: 2, z: 3}, orientation: {x: 0, y: 0, z: 0, w: "
      "1}}\n"
      "---\n"
      "header: {seq: 2}\npose: {position: {x: 4, y: 5, z: 6}, orientation: {x: 0, y: 0, z: 0, w: "
      "1}}\n"
      "---\n";
  const ToolPathFile file = read(text);
  ASSERT_EQ(file.path.segments.size(), 1U);
  EXPECT_EQ(file.path.segments[0].waypoints.size(), 2U);
  const std::vector<YAML::Node> written =
      YAML::LoadAll(tool_path_to_yaml(lifted(file.path), file.layout));
  ASSERT_EQ(written.size(), 2U);
  EXPECT_EQ(written[1]["header"]["seq"].Scalar(), "2");
  EXPECT_EQ(written[1]["pose"]["position"]["z"].Scalar(), "106");
}

TEST(YamlDocuments, WithoutPosesAreRefused) {
  EXPECT_TRUE(
      names(layout_complaint("- [1, 2, 3]\n---\nhello: world\n"), "line 3: no poses found"));
  EXPECT_TRUE(names(layout_complaint("- [1, 2, 3]\n--- {\n"), "line"));
  EXPECT_TRUE(names(layout_complaint("- [1, 2, 3]\n---\n- [1, 2]\n"), "no poses found"));
}

TEST(YamlDocuments, EndWhereTheTextEnds) {
  EXPECT_TRUE(names(layout_complaint("- [1, 2, 3]\n} more\n"), "line"));
  EXPECT_TRUE(names(layout_complaint(", 1000000000"), "line 1: neither part of a document"));
}

TEST(YamlPoses, LeaveNothingUnread) {
  EXPECT_TRUE(
      names(layout_complaint("- {position: {x: 1, y: 2, z: 3, w: 4}}\n"), "'w' in a position"));
  EXPECT_TRUE(names(layout_complaint("- {position: {x: 1, y: 2, z: 3}, speed: 1}\n"
                                     "- {position: {x: 1, y: 2, z: 3}}\n"),
                    "line 2: only some poses have 'speed'"));
  EXPECT_TRUE(names(layout_complaint("- {x: 1, y: 2, z: 3, x: 4}\n"), "'x' occurs twice"));
  EXPECT_TRUE(names(layout_complaint("a: [[1, 2, 3]]\na: [[4, 5, 6]]\n"), "'a' occurs twice"));
  EXPECT_TRUE(
      names(layout_complaint("a: &p {x: 1}\nb:\n- {<<: *p, position: {x: 1, y: 2, z: 3}}\n"),
            "'<<' merges keys"));
  EXPECT_TRUE(names(layout_complaint("a: [[1, 2, 3]]\nb:\n- {xyz: [1, 2, 3]}\n"),
                    "line 3: 'xyz' could be a position"));
  EXPECT_TRUE(
      names(layout_complaint("- {position: {x: 1, y: 2, z: 3}, speed: .nan}\n"), "speed = '.nan'"));
}

TEST(CsvFields, LeaveNothingUnread) {
  EXPECT_THROW(parse_tool_path_csv("x,y,z,segment\n1,2,3,\"a\" b\n", "path"), UnusableInput);
}

TEST(CsvColumns, StayInTheirOrder) {
  const std::string text = "speed,segment,z,y,x\n5,a,3,2,1\n6,b,6,5,4\n";
  const ToolPathFile file = parse_tool_path_csv(text, "path");
  EXPECT_EQ(tool_path_to_csv(file.path, file.layout), text);
}

TEST(OtherFormat, KeepsTheConventionOfThePoses) {
  const std::string csv = "x_mm,y_mm,z_mm,a_deg,e_deg,r_deg,speed\n100,200,300,10,20,30,5\n";
  const ToolPathFile file = parse_tool_path_csv(csv, "path");
  const std::string yaml = tool_path_to_yaml(file.path, file.layout);
  const ToolPathFile again = read(yaml);
  EXPECT_TRUE(again.path.segments[0].waypoints[0].pose.isApprox(
      file.path.segments[0].waypoints[0].pose, 1e-12))
      << yaml;
  EXPECT_EQ(again.path.process_names, std::vector<std::string>{"speed"});
  const ToolPathFile back = parse_tool_path_csv(tool_path_to_csv(again.path, again.layout), "path");
  EXPECT_TRUE(back.path.segments[0].waypoints[0].pose.isApprox(
      file.path.segments[0].waypoints[0].pose, 1e-12));
}
