// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <nav_msgs/Path.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sys/wait.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/sha256.h"

namespace fs = std::filesystem;
using scan_cell_common::save_text;

namespace {

class ExportPathCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("export_path_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    save_text(file("path.csv"), "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n0.1,0,0,0,0,0,1\n");
    save_report("accepted");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    return scan_cell_common::read_file(file(name));
  }

  void save_report(const std::string& verdict) const {
    save_text(
        file("report.json"),
        R"({"verdict": ")" + verdict +
            R"(", "message": "m", "files": {"reference": null, "object": null, "path": null, )"
            R"("output": {"name": "path.csv", "sha256": ")" +
            scan_cell_common::sha256_of_file(file("path.csv")) +
            R"("}}, "quality": [{"in_air": false}, {"in_air": false}]})");
  }

  int run(const std::string& options, const std::string& output = "part.script") const {
    const std::string command = std::string(EXPORT_PATH) + " --path " + file("path.csv") +
                                " --output " + file(output) + " " + options + " > " +
                                file("stdout") + " 2> " + file("stderr");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string report() const { return "--report " + file("report.json") + " "; }

  fs::path folder_;
};

TEST_F(ExportPathCommand, WritesAnAcceptedPathAndNamesTheReport) {
  ASSERT_EQ(run(report() + "--waypoint-z into_part --comment 'part 7'"), 0) << text("stderr");
  EXPECT_NE(text("part.script").find("part 7"), std::string::npos);
  EXPECT_NE(text("part.script")
                .find("verdict: accepted, report sha256 " +
                      scan_cell_common::sha256_of_file(file("report.json")).substr(0, 16)),
            std::string::npos);
}

TEST_F(ExportPathCommand, APathThatWasNotAcceptedLeavesNoProgram) {
  save_text(file("part.script"), "of an earlier part");
  save_report("refused");
  EXPECT_EQ(run(report() + "--waypoint-z into_part"), 2);
  EXPECT_FALSE(fs::exists(file("part.script")));
  save_report("accepted");
  save_text(file("path.csv"), text("path.csv") + "0.2,0,0,0,0,0,1\n");
  EXPECT_EQ(run(report() + "--waypoint-z into_part"), 2) << "edited by hand";
}

TEST_F(ExportPathCommand, WithoutAReportItHasToBeSaid) {
  EXPECT_EQ(run("--waypoint-z into_part"), 1);
  EXPECT_EQ(run("--no-report --waypoint-z into_part"), 0) << text("stderr");
  EXPECT_NE(text("part.script").find("no report"), std::string::npos);
}

TEST_F(ExportPathCommand, WhereTheToolPointsAndWhichLanguageIsNotGuessed) {
  EXPECT_EQ(run("--no-report"), 1);
  EXPECT_NE(text("stderr").find("waypoint"), std::string::npos);
  EXPECT_EQ(run("--no-report --waypoint-z into_part", "part.txt"), 1);
  EXPECT_NE(text("stderr").find("--language"), std::string::npos);
}

TEST_F(ExportPathCommand, NoetherGetsThePathItself) {
  ASSERT_EQ(run(report() + "--language noether", "part.yaml"), 0) << text("stderr");
  EXPECT_NE(text("part.yaml").find("{x: 0.1, y: 0, z: 0, qw: 1, qx: 0, qy: 0, qz: 0}"),
            std::string::npos);
}

/// The suite's arm in its simulated place; the path is in front of it, or out of reach.
TEST_F(ExportPathCommand, TheRobotChecksTheProgramBeforeItIsWritten) {
  const std::string robot = "--no-report --waypoint-z out_of_part --robot " ROBOT_URDF
                            " --cell " CELL_FILE " --start 0 0 -1.57 0 1.57 0";
  save_text(file("path.csv"), "x,y,z,qx,qy,qz,qw\n0,0,0.1,0,0,0,1\n0.1,0,0.1,0,0,0,1\n");
  EXPECT_EQ(run(robot), 0) << text("stderr");
  EXPECT_NE(text("stdout").find("the robot can run it"), std::string::npos) << text("stdout");
  EXPECT_NE(text("part.script").find("qnear"), std::string::npos) << "with the joints' angles";
  save_text(file("path.csv"), "x,y,z,qx,qy,qz,qw\n0,0,0.1,0,0,0,1\n3,0,0.1,0,0,0,1\n");
  EXPECT_EQ(run(robot), 2);
  EXPECT_NE(text("stderr").find("waypoint"), std::string::npos) << text("stderr");
  EXPECT_FALSE(fs::exists(file("part.script")));
  EXPECT_EQ(run("--no-report --waypoint-z out_of_part --robot " ROBOT_URDF), 1);
  EXPECT_NE(text("stderr").find("--cell"), std::string::npos) << text("stderr");
}

TEST_F(ExportPathCommand, ABagHoldsPosesAndJointsWithTheirTimes) {
  save_text(file("path.csv"), "x,y,z,qx,qy,qz,qw\n0,0,0.1,0,0,0,1\n0.1,0,0.1,0,0,0,1\n");
  const std::string command =
      std::string(PATH_TO_BAG) + " --path " + file("path.csv") + " --output " + file("path.bag") +
      " --no-report --waypoint-z out_of_part --speed 0.05 --robot " ROBOT_URDF " --cell " CELL_FILE
      " --start 0 0 -1.57 0 1.57 0 > " +
      file("stdout") + " 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << text("stdout");
  rosbag::Bag bag(file("path.bag"));
  rosbag::View view(bag);
  ASSERT_EQ(view.size(), 2u);
  for (const rosbag::MessageInstance& each : view) {
    if (const auto path = each.instantiate<nav_msgs::Path>()) {
      ASSERT_EQ(path->poses.size(), 4u) << "approach, two waypoints, retract";
      EXPECT_NEAR(path->poses[2].pose.position.x, 0.1, 1e-12);
      EXPECT_EQ(path->poses[2].header.frame_id, "world");
    }
    if (const auto joints = each.instantiate<trajectory_msgs::JointTrajectory>()) {
      ASSERT_EQ(joints->points.size(), 4u);
      EXPECT_EQ(joints->points[0].time_from_start.toSec(), 0);
      // 50 mm to the part and 100 mm along it at 50 mm/s, 50 mm away at 250 mm/s
      EXPECT_NEAR(joints->points[1].time_from_start.toSec(), 1, 1e-9);
      EXPECT_NEAR(joints->points[2].time_from_start.toSec(), 3, 1e-9);
      EXPECT_NEAR(joints->points[3].time_from_start.toSec(), 3.2, 1e-9);
      EXPECT_EQ(joints->points[3].positions.size(), 6u);
    }
  }
}

TEST_F(ExportPathCommand, AFolderThatIsNotThereIsSaid) {
  EXPECT_EQ(run("--no-report --waypoint-z into_part", "none/part.script"), 1);
}

}  // namespace
