// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "teaching/cell_file.h"

namespace fs = std::filesystem;
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

namespace {

const Isometry3d kBaseInWorld =
    Translation3d(-0.8, 0.05, 0.3) * AngleAxisd(0.4, Vector3d(0.1, -0.2, 1).normalized());
const Isometry3d kTipInTool0 = Isometry3d(Translation3d(0.01, -0.02, 0.2));

class CellFramesTool : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Flange poses in which the tip is at the points of world, each with another tilt.
  std::string taught(const std::vector<Vector3d>& points) const {
    std::ofstream file(path("taught.csv"));
    file.precision(12);
    file << "x,y,z,qx,qy,qz,qw\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double direction = 2.4 * static_cast<double>(i);
      const Vector3d axis(std::cos(direction), std::sin(direction), 0);
      const Isometry3d tip =
          Translation3d(kBaseInWorld.inverse() * points[i]) * AngleAxisd(0.5, axis);
      const Isometry3d flange = tip * kTipInTool0.inverse();
      const Eigen::Quaterniond q(flange.linear());
      const Vector3d t = flange.translation();
      file << t.x() << "," << t.y() << "," << t.z() << "," << q.x() << "," << q.y() << "," << q.z()
           << "," << q.w() << "\n";
    }
    return path("taught.csv");
  }

  int run(const std::string& arguments) const {
    const std::string command = std::string(CELL_FRAMES) + " " + arguments + " --cell " +
                                path("cell.yaml") + " > " + path("out.txt") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  std::string printed() const {
    std::ifstream file(path("out.txt"));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_ = fs::temp_directory_path() / ("cell_frames_" + std::to_string(getpid()));
};

}  // namespace

TEST_F(CellFramesTool, FindsTheToolAndThenTheWorldWithIt) {
  ASSERT_EQ(run("tool --poses " + taught(std::vector<Vector3d>(5, Vector3d(0.1, 0.2, 0.03)))), 0)
      << printed();
  EXPECT_NE(printed().find("tool_tip_in_tool0: 10.000 -20.000 200.000 mm"), std::string::npos)
      << printed();
  ASSERT_EQ(run("world --points " + taught({{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}})), 0)
      << printed();
  const scan_calibration::Cell cell = scan_calibration::load_cell(path("cell.yaml"));
  EXPECT_TRUE(cell.tool_tip_in_tool0.isApprox(kTipInTool0, 1e-9));
  EXPECT_TRUE(cell.base_link_in_world.isApprox(kBaseInWorld, 1e-9));
}

TEST_F(CellFramesTool, RefusesTheOldNamesOfItsOptionsAndSaysTheNewOnes) {
  const auto refused = [this](const std::string& command, const std::string& old,
                              const std::string& now) {
    EXPECT_EQ(run(command + " " + old + " 1"), 1);
    EXPECT_EQ(printed(), "cell_frames: " + old + ": renamed; use " + now + "\n");
  };
  refused("tool", "--most-condition", "--max-condition");
  refused("tool", "--most-residual", "--max-residual");
  refused("world", "--least-distance", "--min-distance");
  refused("world", "--most-skew", "--max-skew");
}

TEST_F(CellFramesTool, WritesNothingAndSaysWhyWhereItFails) {
  EXPECT_EQ(run("tool --poses " + taught(std::vector<Vector3d>(2, Vector3d(0.1, 0.2, 0.03)))), 1);
  EXPECT_NE(printed().find("at least three orientations"), std::string::npos) << printed();
  EXPECT_EQ(run("world --points " + taught({{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.2, 0}})), 1);
  EXPECT_NE(printed().find("cell.yaml"), std::string::npos) << printed();  // no tool tip in it yet
  std::ofstream(path("points.csv")) << "x,y,z\n0,0,0\n0.3,0,0\n0.6,0,0\n";
  EXPECT_EQ(run("world --points " + path("points.csv")), 1);
  EXPECT_NE(printed().find("0.00 mm"), std::string::npos) << printed();
  EXPECT_EQ(run("tool --poses " + path("points.csv")), 1);
  EXPECT_NE(printed().find("points without orientation"), std::string::npos) << printed();
  EXPECT_FALSE(fs::exists(path("cell.yaml")));
}
