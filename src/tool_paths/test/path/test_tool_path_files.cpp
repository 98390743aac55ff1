// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <fstream>
#include <map>

#include "path/complaints.h"
#include "path/tool_path_file_targets.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;
using namespace tool_paths;
using scan_cell_common::Error;
using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

namespace {

template <class Parser>
std::string complaint(Parser parse, const std::string& text) {
  return complaint_of([&] { parse(text, "path", {}); });
}

std::string csv_complaint(const std::string& text) {
  return complaint(parse_tool_path_csv, text);
}

ToolPath example() {
  ToolPath path;
  path.name = "rim";
  path.has_orientation = true;
  path.process_names = {"speed", "force"};
  path.segments = {{"outer, left", {}}, {"inner \"b\"", {}}, {"inner \"b\"", {}}};
  double angle = 0.1;
  for (Segment& segment : path.segments) {
    for (int i = 0; i < 3; ++i) {
      Waypoint waypoint;
      angle += 0.7;
      waypoint.pose = Eigen::Translation3d(angle / 3, -1e-7 * angle, 1 / angle) *
                      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -2).normalized());
      waypoint.process_values = {angle / 7, -3};
      segment.waypoints.push_back(waypoint);
    }
  }
  return path;
}

void expect_same(const ToolPath& a, const ToolPath& b) {
  EXPECT_EQ(a.process_names, b.process_names);
  EXPECT_EQ(a.has_orientation, b.has_orientation);
  ASSERT_EQ(a.segments.size(), b.segments.size());
  for (std::size_t s = 0; s < a.segments.size(); ++s) {
    ASSERT_EQ(a.segments[s].waypoints.size(), b.segments[s].waypoints.size());
    for (std::size_t w = 0; w < a.segments[s].waypoints.size(); ++w) {
      const Waypoint& one = a.segments[s].waypoints[w];
      const Waypoint& other = b.segments[s].waypoints[w];
      EXPECT_EQ(one.pose.translation(), other.pose.translation());
      EXPECT_TRUE(one.pose.linear().isApprox(other.pose.linear(), 1e-14));
      EXPECT_EQ(one.process_values, other.process_values);
    }
  }
}

const char* const kNested = R"(- dwell_time: 0
  tool_offset:
    position: {x: 0, y: 0, z: 0}
    orientation: {x: 1, y: 0, z: 0, w: 6.1e-17}
  paths:
    - poses:
        - orientation: {z: 0, w: 1, x: 0, y: 0}
          position: {x: 0.5, y: -0.25, z: 0.125}
        - position: {x: 1, y: 2, z: 3}
          orientation: {x: 0, y: 0, z: 1, w: 0}
      header: {seq: 4}
    - header: {seq: 3}
      poses:
        - position: {x: 7, y: 8, z: 9}
          orientation: {x: 0, y: 0, z: 0, w: 1}
)";

}  // namespace

TEST(ToolPathCsv, IsReadByTheNamesOfItsColumns) {
  const ToolPath path =
      parse_tool_path_csv(
          "speed,z,y,x,segment\n# a comment\n0.5, 3,2,1,a\r\n0.6,6,5,4,a\n\n0.7,9,8,7,b\n", "path")
          .path;
  ASSERT_EQ(path.segments.size(), 2U);
  EXPECT_FALSE(path.has_orientation);
  EXPECT_EQ(path.process_names, std::vector<std::string>{"speed"});
  EXPECT_EQ(path.segments[0].name, "a");
  EXPECT_EQ(path.segments[0].waypoints[0].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(path.segments[1].waypoints[0].pose.translation(), Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(path.segments[1].waypoints[0].process_values, std::vector<double>{0.7});
}

TEST(ToolPathCsv, TurnsTheQuaternionTheRightWay) {
  const double half = std::sqrt(0.5);
  const ToolPath path = parse_tool_path_csv("x,y,z,qx,qy,qz,qw\n0,0,0,0,0," + std::to_string(half) +
                                                "," + std::to_string(half),
                                            "path")
                            .path;
  const Eigen::Vector3d turned =
      path.segments[0].waypoints[0].pose.linear() * Eigen::Vector3d::UnitX();
  EXPECT_TRUE(turned.isApprox(Eigen::Vector3d::UnitY(), 1e-6));
}

TEST(ToolPathCsv, NamesTheLineOfWhatIsWrong) {
  const std::string head = "x,y,z,qx,qy,qz,qw\n";
  EXPECT_TRUE(names(csv_complaint(head + "0,0,0,0,0,0,1\n0,nan,0,0,0,0,1\n"), "line 3: y = 'nan'"));
  EXPECT_TRUE(names(csv_complaint(head + "0,inf,0,0,0,0,1\n"), "line 2: y = 'inf'"));
  EXPECT_TRUE(names(csv_complaint(head + "0,1 2,0,0,0,0,1\n"), "line 2: y = '1 2'"));
  EXPECT_TRUE(names(csv_complaint(head + "0,0,0,0,0,0,2\n"), "line 2: a quaternion of length 2"));
  EXPECT_TRUE(names(csv_complaint(head + "0,0,0,0,0,0,0\n"), "line 2: a quaternion of length 0"));
  EXPECT_TRUE(names(csv_complaint(head + "0,0,0\n"), "line 2: 3 values"));
  EXPECT_TRUE(names(csv_complaint("x,y\n1,2\n"), "no column 'z'"));
  EXPECT_TRUE(names(csv_complaint("x,y,z,qx\n1,2,3,4\n"), "only some of the columns"));
  EXPECT_TRUE(names(csv_complaint("x,y,z,x\n1,2,3,4\n"), "occurs twice"));
  EXPECT_TRUE(names(csv_complaint("1,2,3\n4,5,6\n"), "no column 'x'"));
  EXPECT_TRUE(names(csv_complaint("x,y,z,segment\n1,2,3,\"a\n"), "quote"));
  EXPECT_TRUE(names(csv_complaint(head), "no waypoints"));
  EXPECT_TRUE(names(csv_complaint(""), "empty"));
}

TEST(ToolPathYaml, TakesTheInnerArraysOfPosesAsSegments) {
  const ToolPath path = parse_tool_path_yaml(kNested, "path").path;
  ASSERT_EQ(path.segments.size(), 2U);
  ASSERT_EQ(path.segments[0].waypoints.size(), 2U);
  ASSERT_EQ(path.segments[1].waypoints.size(), 1U);
  EXPECT_TRUE(path.has_orientation);
  EXPECT_EQ(path.segments[0].waypoints[0].pose.translation(), Eigen::Vector3d(0.5, -0.25, 0.125));
  EXPECT_EQ(path.segments[1].waypoints[0].pose.translation(), Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(path.segments[0].waypoints[1].pose.linear().isApprox(
      Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ()).toRotationMatrix(), 1e-12));
}

TEST(ToolPathYaml, TakesPlainListsToo) {
  const ToolPath one = parse_tool_path_yaml("[[1, 2, 3], [4, 5, 6]]", "path").path;
  ASSERT_EQ(one.segments.size(), 1U);
  EXPECT_EQ(one.segments[0].waypoints[1].pose.translation(), Eigen::Vector3d(4, 5, 6));
  const ToolPath two =
      parse_tool_path_yaml("- [[1, 2, 3, 0, 0, 0, 1]]\n- [[4, 5, 6, 0, 0, 0, 1]]\n", "path").path;
  ASSERT_EQ(two.segments.size(), 2U);
  EXPECT_TRUE(two.has_orientation);
}

TEST(ToolPathYaml, NamesTheLineOfWhatIsWrong) {
  EXPECT_TRUE(names(yaml_complaint("- [1, 2, 3]\n- [1, .nan, 3]\n"), "line 2"));
  EXPECT_TRUE(names(yaml_complaint("- [1, 2, 3]\n- [1, 2]\n"), "line 2: not a pose"));
  EXPECT_TRUE(names(yaml_complaint("- [1, 2, 3, 0, 0, 0, 3]\n"), "length 3"));
  EXPECT_TRUE(names(yaml_complaint("- position: {x: 1, y: 2}\n"), "no 'z'"));
  EXPECT_TRUE(names(yaml_complaint("- position: {x: 1, y: 2, z: far}\n"), "z = 'far'"));
  EXPECT_TRUE(names(yaml_complaint("- [1, 2, 3]\n- [1, 2, 3, 0, 0, 0, 1]\n"), "only some poses"));
  EXPECT_TRUE(names(yaml_complaint("a: [1, 2"), "line 1"));
  EXPECT_TRUE(names(yaml_complaint(""), "no poses"));
  EXPECT_TRUE(names(yaml_complaint("hello: world"), "no poses"));
}

TEST(ToolPathYaml, LosesNoPoseOfAListThatBeginsWithSomethingElse) {
  const std::string whole = "whole: [[1, 2, 3]]\n";
  const std::string mixed = whole + "mixed:\n- name: approach\n- position: {x: 1, y: 2, z: 3}\n";
  EXPECT_TRUE(
      names(yaml_complaint(mixed), "line 4: a pose in a list that does not begin with one"));
  EXPECT_TRUE(names(yaml_complaint(whole + "mixed: [7, [1, 2, 3]]\n"), "line 2: a pose in a list"));
}

TEST(ToolPathYaml, RefusesAliasesWithinThemselves) {
  EXPECT_TRUE(names(yaml_complaint("a: &a [*a]"), "nested more than 64 deep"));
  EXPECT_TRUE(names(yaml_complaint("a: &a {b: *a}"), "nested more than 64 deep"));
  EXPECT_TRUE(names(yaml_complaint("a: &a [*a, *a, *a]"), "nested more than 64 deep"));
}

TEST(ToolPathYaml, RefusesAliasesThatStandForEndlessPaths) {
  std::string text = "a0: &a0 [[1,2,3],[1,2,3],[1,2,3],[1,2,3],[1,2,3],[1,2,3],[1,2,3],[1,2,3]]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int k = 0; k < 8; ++k)
      text += (k > 0 ? ", " : "") + last;
    text += "]\n";
  }
  EXPECT_TRUE(names(yaml_complaint(text), "entries"));
}

TEST(ToolPathFiles, ComeBackToTheLastDigit) {
  const std::string base =
      (fs::temp_directory_path() / ("path_" + std::to_string(getpid()))).string();
  for (const char* ending : {".csv", ".yaml"}) {
    save_tool_path(base + ending, example());
    const ToolPath loaded = load_tool_path(base + ending);
    expect_same(example(), loaded);
    EXPECT_EQ(loaded.segments[0].name, "outer, left");
    EXPECT_EQ(loaded.segments[1].name, "inner \"b\"");
    fs::remove(base + ending);
  }
}

TEST(ToolPathFiles, AreRefusedWhereMissingOrOfAnotherKind) {
  EXPECT_THROW(load_tool_path("/no/such/path.csv"), FileError);
  EXPECT_THROW(load_tool_path("path.txt"), FileError);
  EXPECT_THROW(save_tool_path("/no/such/folder/path.csv", example()), FileError);
  EXPECT_THROW(save_tool_path("empty.csv", ToolPath{}), UnusableInput);
  EXPECT_THROW(check_tool_path_name("path.txt"), FileError);
  EXPECT_THROW(check_tool_path_name("/no/such/folder/path.yaml"), FileError);
  EXPECT_NO_THROW(check_tool_path_name((fs::temp_directory_path() / "path.YML").string()));
}

TEST(ToolPathFiles, AreReadOrRefusedWhateverIsInThem) {
  for (const auto& target : tool_path_file_targets()) {
    SCOPED_TRACE(target.name);
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const std::uint64_t runs = 20000 / target.cost;
    const auto count = scan_cell_common::fuzz(target, 1, runs);
    EXPECT_GT(count.taken, runs / 20);
    EXPECT_GT(count.refused, runs / 4);
  }
}

TEST(ToolPathCsv, IsReadAsSpreadsheetsWriteIt) {
  const ToolPath path = parse_tool_path_csv("\xef\xbb\xbfx,y,z\r\n+0.5,0.25,1\r\n", "path").path;
  EXPECT_EQ(path.segments[0].waypoints[0].pose.translation(), Eigen::Vector3d(0.5, 0.25, 1));
  EXPECT_TRUE(
      names(csv_complaint("x;y;z\n0,5;1;2\n"), "separated by ';'; separate them by commas"));
  EXPECT_TRUE(names(csv_complaint("x,y,z\n0,5,1,25,2,0\n"), "line 2: 6 values"));
  EXPECT_TRUE(names(csv_complaint("x,y,z\n0,5,1,25,2,0\n"), "write 0.5, not 0,5"));
}

TEST(ToolPathYaml, ComesBackFromNoethersForm) {
  ToolPath path;
  path.has_orientation = true;
  for (int s = 0; s < 2; ++s) {
    Segment segment;
    for (int i = 0; i < 3; ++i) {
      Waypoint waypoint;
      waypoint.pose.translation() << 0.1 * i, 0.01 * s, -1.0 / 3;
      waypoint.pose.rotate(Eigen::AngleAxisd(2 + i, Eigen::Vector3d(1, 2, 3).normalized()));
      segment.waypoints.push_back(waypoint);
    }
    path.segments.push_back(segment);
  }
  const std::string text = tool_path_to_noether_yaml(path);
  // a list of tool paths of segments of waypoints
  const YAML::Node node = YAML::Load(text);
  ASSERT_EQ(node.size(), 1u);
  ASSERT_EQ(node[0].size(), 2u);
  EXPECT_EQ(node[0][1][2]["x"].as<double>(), 0.2);
  const ToolPath again = parse_tool_path_yaml(text, "noether").path;
  ASSERT_EQ(again.segments.size(), 2u);
  for (int s = 0; s < 2; ++s)
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(
          again.segments[s].waypoints[i].pose.isApprox(path.segments[s].waypoints[i].pose, 1e-12));
  path.has_orientation = false;
  EXPECT_THROW(tool_path_to_noether_yaml(path), UnusableInput);
}

TEST(ToolPathYaml, IsReadAsEditorsWriteIt) {
  const ToolPath path =
      parse_tool_path_yaml("\xef\xbb\xbf- [1, 2, 3]\r\n- [4, 5, 6]\r\n", "path").path;
  EXPECT_EQ(path.segments[0].waypoints[1].pose.translation(), Eigen::Vector3d(4, 5, 6));
  EXPECT_TRUE(names(yaml_complaint("- [\"0,5\", 1, 2]\n"), "x = '0,5'"));
}

TEST(ToolPathFiles, SayShortlyWhatIsWrongInAHugeLine) {
  const std::string huge(3000000, '7');
  std::string quotes = "a";
  std::string columns = "x,y,z";
  for (int i = 0; i < 300000; ++i) {
    quotes += "a\"";
    columns += ",c" + std::to_string(i);
  }
  for (const std::string& text :
       {"x,y,z\n1,2," + huge + "x\n", "x,y,z\n" + quotes + "\n", huge, columns + "\n1,2,3\n"}) {
    const std::string message = csv_complaint(text);
    EXPECT_FALSE(message.empty());
    EXPECT_LT(message.size(), 200U);
  }
  EXPECT_LT(yaml_complaint("- [1, 2, " + huge + "x]").size(), 200U);
}

TEST(ToolPathFiles, AreRefusedByNameWhereTheyAreOfAnotherKind) {
  const fs::path folder = fs::temp_directory_path() / ("paths_" + std::to_string(getpid()));
  fs::create_directories(folder / "folder.csv");
  std::ofstream(folder / "utf16.csv") << std::string("\xff\xfex\0,\0", 6);
  std::ofstream(folder / "picture.csv") << "\x89PNG\r\n\x1a\n" << std::string(100, '\0');
  std::ofstream(folder / "picture.yaml") << "\x89PNG\r\n\x1a\n" << std::string(100, '\0');
  std::ofstream(folder / "empty.yaml");
  const std::map<std::string, std::string> complaints = {{"folder.csv", "a folder"},
                                                         {"utf16.csv", "line 1: not UTF-8"},
                                                         {"picture.csv", "line 1: not UTF-8"},
                                                         {"picture.yaml", "picture.yaml"},
                                                         {"empty.yaml", "no poses"}};
  for (const auto& [name, part] : complaints) {
    try {
      load_tool_path((folder / name).string());
      ADD_FAILURE() << name;
    } catch (const Error& error) {
      EXPECT_TRUE(names(error.what(), name)) << error.what();
      EXPECT_TRUE(names(error.what(), part)) << error.what();
    }
  }
  fs::remove_all(folder);
}
