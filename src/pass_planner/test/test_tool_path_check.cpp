// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "pass_planner/tool_path_report.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "tool_paths/tool_path_files.h"

namespace pass_planner {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

/// A path of two segments in world, z out of the part, that the robot 0.8 m away can follow.
class ToolPathCheckTest : public testing::Test {
 protected:
  ToolPathCheckTest() {
    robot_.urdf = scan_cell_common::read_file(URDF_FILE);
    robot_.base_link_in_world = Translation3d(-0.8, 0.05, 0) * AngleAxisd(0.3, Vector3d::UnitZ());
    robot_.limits.operation = c4g_driver::Operation::kAutomatic;
    process_.waypoint_z = tool_path_programs::WaypointZ::kOutOfPart;
    path_.name = "weld";
    path_.has_orientation = true;
    path_.segments = {{"first", {}}, {"second", {}}};
    for (int i = 0; i < 21; ++i) {
      path_.segments[0].waypoints.push_back(
          {Isometry3d(Translation3d(0, 0.01 * i - 0.1, 0.3)), {}});
      path_.segments[1].waypoints.push_back(
          {Isometry3d(Translation3d(0.1, 0.01 * i - 0.1, 0.3)), {}});
    }
  }

  PathForRobot asked() const {
    return path_for_robot(path_, process_, ToolPathCheck(robot_).frame_in_base_link(), tip_);
  }

  c4g_driver::ToolCheck check() const {
    return ToolPathCheck(robot_).check(asked(), parameters_, nullptr);
  }

  RobotInCell robot_;
  tool_path_programs::ExportParameters process_;
  tool_paths::ToolPath path_;
  c4g_driver::ToolCheckParameters parameters_;
  const Isometry3d tip_ = Isometry3d(Translation3d(0, 0, 0.2));
};

TEST_F(ToolPathCheckTest, PutsThePathBeforeTheRobotWithApproachesAndRetracts) {
  const PathForRobot robot_path = asked();
  ASSERT_EQ(robot_path.motion.waypoints.size(), 46u);  // 2 x (21 + approach + retract)
  EXPECT_FALSE(robot_path.waypoint[0]);
  EXPECT_EQ(robot_path.waypoint[1], 0u);
  EXPECT_EQ(robot_path.waypoint[24], 21u);
  const Isometry3d tip = robot_.base_link_in_world * robot_path.motion.waypoints[1].tip;
  EXPECT_TRUE(tip.translation().isApprox(Vector3d(0, -0.1, 0.3), 1e-12));
  EXPECT_TRUE(tip.linear().col(2).isApprox(-Vector3d::UnitZ(), 1e-12));
  const Isometry3d front = robot_.base_link_in_world * robot_path.motion.waypoints[0].tip;
  EXPECT_TRUE(front.translation().isApprox(Vector3d(0, -0.1, 0.35), 1e-12));
  EXPECT_EQ(tool_path_programs::place_on_path(robot_path.waypoint, 0, 1),
            "the approach to waypoint 0");
  EXPECT_EQ(tool_path_programs::place_on_path(robot_path.waypoint, 2, 1), "waypoint 1");
  EXPECT_EQ(tool_path_programs::place_on_path(robot_path.waypoint, 24, 0.25),
            "25 % of the way to waypoint 21");
  EXPECT_EQ(tool_path_programs::place_on_path(robot_path.waypoint, 22, 1),
            "the retract from waypoint 20");
  EXPECT_EQ(tool_path_programs::place_on_path(robot_path.waypoint, 23, 1),
            "the approach to waypoint 21");
}

TEST_F(ToolPathCheckTest, PassesItAndFindsTheWayToItsBegin) {
  const c4g_driver::ToolCheck found = check();
  EXPECT_TRUE(found.possible()) << found.refusal();
  const ToolPathCheck robot(robot_);
  EXPECT_EQ(robot.approach_refusal(found, 0.1), "");
  for (std::size_t i = 0; i < found.joints.size(); ++i) {
    EXPECT_TRUE((robot.model().flange_at(found.joints[i]) * tip_)
                    .isApprox(asked().motion.waypoints[i].tip, 1e-7));
  }
  robot_.start[0] = 2.9;  // turned away: the flange would leave the box as it swings round
  robot_.limits.workspace_min.y() = -0.5;
  const std::string refusal = ToolPathCheck(robot_).approach_refusal(found, 0.1);
  EXPECT_NE(refusal.find("way of the flange, y"), std::string::npos) << refusal;
}

TEST_F(ToolPathCheckTest, TellsFaultsByTheWaypointsOfThePath) {
  path_.segments[1].waypoints[7].pose.translation().x() = 3;
  const c4g_driver::ToolCheck found = check();
  ASSERT_FALSE(found.possible());
  const auto json = nlohmann::json::parse(tool_check_to_json(asked(), found, ""));
  EXPECT_FALSE(json["possible"]);
  std::set<std::size_t> unreached;
  for (const auto& fault : json["faults"]) {
    if (fault["kind"] == "reach") unreached.insert(fault["waypoint"].get<std::size_t>());
  }
  EXPECT_EQ(unreached, (std::set<std::size_t>{28, 29}));  // on the way there, and back
  EXPECT_TRUE(json["steps"][31]["joints"].is_null());
  EXPECT_EQ(json["steps"][31]["waypoint"], 28);
  EXPECT_EQ(json["steps"][30]["joints"].size(), 6u);
  const std::string text = summary_of(asked(), found, "J2 is in the way");
  EXPECT_NE(text.find("the way to waypoint 28"), std::string::npos) << text;
  EXPECT_NE(text.find("on the way to the start: J2 is in the way"), std::string::npos) << text;
}

TEST_F(ToolPathCheckTest, WritesThePathWithTheTurnsThatWereChosen) {
  const PathForRobot robot_path = asked();
  std::vector<Isometry3d> turned;
  for (const c4g_driver::ToolWaypoint& waypoint : robot_path.motion.waypoints)
    turned.push_back(waypoint.tip * AngleAxisd(0.4, Vector3d::UnitZ()));
  const tool_paths::ToolPath result = turned_path(path_, robot_path, turned);
  // the tool's z is against that of the waypoints
  const Eigen::Matrix3d expected = AngleAxisd(-0.4, Vector3d::UnitZ()).toRotationMatrix();
  for (std::size_t segment = 0; segment < 2; ++segment) {
    for (std::size_t i = 0; i < 21; ++i) {
      const Isometry3d& pose = result.segments[segment].waypoints[i].pose;
      EXPECT_TRUE(pose.linear().isApprox(expected, 1e-12));
      EXPECT_EQ(pose.translation(), path_.segments[segment].waypoints[i].pose.translation());
    }
  }
}

/// The tool itself, with files.
class CheckPathTool : public ToolPathCheckTest {
 protected:
  CheckPathTool() {
    tool_paths::save_tool_path(file("path.csv"), path_);
    scan_cell_common::save_text(file("shapes.yaml"),
                                "shapes: [{name: bracket, frame: flange, box: [0.6, 0.04, 0.04]}]");
    // a cloud of a post, beside the path at the flange's height, where the bracket's end comes by
    std::string post = "x,y,z\n";
    for (int i = 0; i < 200; ++i)
      post += "0.25,0.05," + std::to_string(0.4 + 0.001 * i) + "\n";
    scan_cell_common::save_text(file("post.csv"), post);
  }

  static std::string file(const std::string& name) {
    return testing::TempDir() + "check_path_" + name;
  }

  static int run(const std::string& more) {
    const std::string command = std::string(CHECK_PATH) + " --path " + file("path.csv") +
                                " --cell " + CELL_FILE + " --urdf " + URDF_FILE +
                                " --waypoint-z out_of_part --output " + file("found.json") + " " +
                                more + " > " + file("said.txt") + " 2>&1";
    const int status = std::system(command.c_str());
    return WEXITSTATUS(status);
  }

  static std::string said() { return scan_cell_common::read_file(file("said.txt")); }
  static nlohmann::json found() {
    return nlohmann::json::parse(scan_cell_common::read_file(file("found.json")));
  }
};

TEST_F(CheckPathTool, SaysYesAndNoByItsExitCode) {
  EXPECT_EQ(run(""), 0) << said();
  EXPECT_TRUE(found()["possible"]);
  EXPECT_EQ(run("--speed 0.3"), 2) << said();
  EXPECT_EQ(found()["faults"][0]["kind"], "tool_speed");
  EXPECT_EQ(run("--workspace-max 0.7 1.4 1.9"), 2) << said();
  EXPECT_EQ(found()["faults"][0]["kind"], "workspace");
  EXPECT_EQ(run("--frame cloud"), 1) << said();
  EXPECT_EQ(run("--part " + file("post.csv")), 1) << said();
  EXPECT_NE(said().find("give --shapes"), std::string::npos) << said();
}

TEST_F(CheckPathTool, TurnsTheBracketRoundAPost) {
  const std::string post = "--shapes " + file("shapes.yaml") + " --part " + file("post.csv");
  EXPECT_EQ(run(post), 2) << said();
  EXPECT_NE(said().find("bracket and part: collide"), std::string::npos) << said();
  EXPECT_EQ(run(post + " --free-about-z --turned-path " + file("turned.csv")), 0) << said();
  const auto turned = tool_paths::load_tool_path(file("turned.csv"));
  double most = 0;
  for (std::size_t i = 0; i < 21; ++i) {
    const Isometry3d& pose = turned.segments[0].waypoints[i].pose;
    EXPECT_LT((pose.linear().col(2) - Vector3d::UnitZ()).norm(), 1e-9);
    EXPECT_LT((pose.translation() - path_.segments[0].waypoints[i].pose.translation()).norm(),
              1e-12);
    most = std::max(most, AngleAxisd(pose.linear()).angle());
  }
  EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace pass_planner
