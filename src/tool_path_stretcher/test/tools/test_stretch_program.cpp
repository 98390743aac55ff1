// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/files/files.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/surface.h"
#include "tool_paths/tool_path_files.h"

namespace fs = std::filesystem;
using namespace tool_path_stretcher;

namespace {

/// A URScript pose: metres and a rotation vector.
std::string script_pose(const Eigen::Isometry3d& pose) {
  const Eigen::AngleAxisd turn(pose.linear());
  const Eigen::Vector3d v = turn.angle() * turn.axis();
  char text[200];
  std::snprintf(text, sizeof text, "p[%.7f, %.7f, %.7f, %.7f, %.7f, %.7f]", pose.translation().x(),
                pose.translation().y(), pose.translation().z(), v.x(), v.y(), v.z());
  return text;
}

std::vector<Eigen::Isometry3d> poses_in(const std::string& script) {
  static const std::regex pose(R"(movel\(p\[([^\]]*)\])");
  std::vector<Eigen::Isometry3d> poses;
  for (std::sregex_iterator at(script.begin(), script.end(), pose), end; at != end; ++at) {
    std::string numbers = (*at)[1];
    std::replace(numbers.begin(), numbers.end(), ',', ' ');
    std::istringstream in(numbers);
    Eigen::Vector3d place, turn;
    in >> place.x() >> place.y() >> place.z() >> turn.x() >> turn.y() >> turn.z();
    Eigen::Isometry3d result(Eigen::Translation3d{place});
    if (turn.norm() > 0) result.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
    poses.push_back(result);
  }
  return poses;
}

class StretchProgram : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("stretch_program_" + std::to_string(getpid()));
    fs::create_directories(folder_);
    synthetic::Scan whole;
    whole.seed = 11;
    const auto none = synthetic::no_deformation();
    scan_cell_common::save_cloud(file("r.ply"), to_cloud(synthetic::scan(part_, {}, none, whole)));
    scan_cell_common::save_cloud(file("d.ply"), to_cloud(synthetic::scan(part_, moved_, none, {})));
    path_ = synthetic::path_on(part_, 100);
    tool_paths::save_tool_path(file("p.csv"), path_);
    scan_cell_common::save_text(file("p.script"), program());
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string text(const std::string& name) const {
    return scan_cell_common::read_file(file(name));
  }

  /// As written by a person, with statements unrelated to poses.
  std::string program() const {
    std::string text =
        "def glue():\r\n  # nozzle 3,  do not touch\r\n  movej([0, -1.57, 1.57, -1.57, "
        "-1.57, 0], a=1.2, v=0.5)\r\n  textmsg(\"start\")\r\n";
    for (const auto& segment : path_.segments) {
      text += "  set_digital_out(3,   True) # on\r\n";
      for (const auto& waypoint : segment.waypoints)
        text += "\tmovel(" + script_pose(waypoint.pose) + ", a=0.5,v=0.05, r=0.0001)\r\n";
      text += "  sleep(0.25)\r\n  set_digital_out(3, False)\r\n";
    }
    return text + "end\r\n";
  }

  /// An arc along the sharpest corner of the path, between two lines.
  std::string arc_program() const {
    const auto& waypoints = path_.segments.front().waypoints;
    const auto height = [&](std::size_t i) {
      const Eigen::Vector3d chord =
          waypoints[i + 2].pose.translation() - waypoints[i - 2].pose.translation();
      const Eigen::Vector3d side =
          waypoints[i].pose.translation() - waypoints[i - 2].pose.translation();
      return side.cross(chord).norm() / chord.norm();
    };
    std::size_t corner = 3;
    for (std::size_t i = 3; i + 3 < waypoints.size(); ++i)
      if (height(i) > height(corner)) corner = i;
    const auto pose = [&](std::size_t i) { return script_pose(waypoints[i].pose); };
    return "def glue():\n  movel(" + pose(corner - 2) + ", a=0.5, v=0.05)\n  movec(" +
           pose(corner) + ", " + pose(corner + 2) + ", a=0.5, v=0.05) # corner\n  movel(" +
           pose(corner + 3) + ", a=0.5, v=0.05)\nend\n";
  }

  int stretch(const std::string& path, const std::string& output, const std::string& more = "") {
    const std::string command = std::string(STRETCH_COMMAND) + " --reference " + file("r.ply") +
                                " --object " + file("d.ply") + " --path " + file(path) +
                                " --output " + file(output) + " --report " + file("report.json") +
                                " " + more + " > " + file("stdout") + " 2> " + file("stderr");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  fs::path folder_;
  synthetic::Part part_ = synthetic::photo_frame();
  Similarity moved_ = synthetic::similarity(
      1.08, Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {0.3, 0.1, 0});
  ToolPath path_;
};

/// The script without the numbers of poses.
std::string without_poses(const std::string& script) {
  return std::regex_replace(script, std::regex(R"(p\[[^\]]*\])"), "p[]");
}

}  // namespace

TEST_F(StretchProgram, GivesTheSameProgramWithTheAdaptedPoses) {
  ASSERT_EQ(stretch("p.csv", "out.csv"), 0) << text("stderr");
  ASSERT_EQ(stretch("p.script", "out.script"), 0) << text("stderr");
  EXPECT_EQ(without_poses(text("out.script")), without_poses(text("p.script")));
  const ToolPath expected = tool_paths::load_tool_path(file("out.csv"));
  const auto poses = poses_in(text("out.script"));
  std::size_t i = 0;
  for (const auto& segment : expected.segments) {
    for (const auto& waypoint : segment.waypoints) {
      ASSERT_LT(i, poses.size());
      const Eigen::Isometry3d off = waypoint.pose.inverse() * poses[i++];
      EXPECT_LT(off.translation().norm(), 2e-6) << "rounding of both files";
      EXPECT_LT(Eigen::AngleAxisd(off.linear()).angle(), 2e-5);
    }
  }
  EXPECT_EQ(i, poses.size());
  EXPECT_NE(text("stdout").find("p.script, line 3: goes to angles of the axes; it stays as it is"),
            std::string::npos)
      << text("stdout");
}

TEST_F(StretchProgram, RefusesWhatItCannotResolveByFileAndLine) {
  scan_cell_common::save_text(
      file("p.script"),
      program() +
          "def more():\n  movel(pose_add(get_actual_tcp_pose(), p[0,0,0.1,0,0,0]))\nend\nmore()\n");
  EXPECT_EQ(stretch("p.script", "out.script"), 1);
  EXPECT_FALSE(fs::exists(file("out.script")));
  EXPECT_NE(text("stderr").find("p.script, line "), std::string::npos) << text("stderr");
}

TEST_F(StretchProgram, WritesAnArcAsLinesWhereItMissesTheAdaptedPathAndSaysSo) {
  scan_cell_common::save_text(file("arc.script"), arc_program());
  ASSERT_EQ(stretch("arc.script", "out.script", "--arc-tolerance 0.002"), 0) << text("stderr");
  EXPECT_EQ(without_poses(text("out.script")), without_poses(arc_program()));
  ASSERT_EQ(stretch("arc.script", "lines.script", "--arc-tolerance 0"), 0) << text("stderr");
  const std::string lines = text("lines.script");
  EXPECT_EQ(lines.find("movec"), std::string::npos);
  EXPECT_EQ(lines.find("# corner"), lines.rfind("# corner"));
  const auto old = poses_in(text("out.script")), poses = poses_in(lines);
  ASSERT_GT(poses.size(), old.size() + 1);
  // more places along the arc adapt it slightly differently
  EXPECT_LT((poses.front().translation() - old.front().translation()).norm(), 1e-4);
  EXPECT_LT((poses.back().translation() - old.back().translation()).norm(), 1e-4);
  EXPECT_NE(text("stdout").find("arc.script, line 3: on the part this arc is no longer a circle"),
            std::string::npos)
      << text("stdout");
}

TEST_F(StretchProgram, KeepsItsMovesAndItsLanguage) {
  EXPECT_EQ(stretch("p.script", "out.script", "--resample-spacing 0.001"), 1);
  EXPECT_EQ(stretch("p.script", "out.csv"), 1);
  EXPECT_EQ(stretch("p.script", "p.script"), 1);
  EXPECT_EQ(text("p.script"), program()) << "the input is never overwritten";
}
