// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_calibration/taught_poses.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "teaching/cell_file.h"

namespace fs = std::filesystem;
using scan_calibration::Cell;
using scan_calibration::TaughtPoses;

namespace {

class Files : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  std::string write(const std::string& text) const {
    std::ofstream(path_) << text;
    return path_;
  }

  template <class Load>
  std::string complaint(const std::string& text, const Load& load) const {
    try {
      load(write(text));
    } catch (const scan_cell_common::Error& error) {
      return std::string(error.what()).substr(path_.size());
    }
    return "nothing";
  }

  std::string path_ =
      (fs::temp_directory_path() / ("calibration_" + std::to_string(getpid()))).string();
};

class CellFile : public Files {
 protected:
  std::string complaint(const std::string& text) const {
    return Files::complaint(text, scan_calibration::load_cell);
  }
};

class TaughtPosesFile : public Files {
 protected:
  std::string complaint(const std::string& text) const {
    return Files::complaint(text, scan_calibration::load_taught_poses);
  }
};

Cell example() {
  return {Eigen::Translation3d(-0.8, 1.0 / 3, 0) *
              Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()),
          Eigen::Isometry3d(Eigen::Translation3d(0, 1e-5, 0.2))};
}

const char* const kBase = "base_link_in_world: {translation: [1, 2, 3], rotation: [0, 0, 0, 1]}\n";
const char* const kTool = "tool_tip_in_tool0: {translation: [0, 0, 0.2], rotation: [0, 0, 0, 1]}\n";

}  // namespace

TEST_F(CellFile, ComesBackToTheLastDigit) {
  scan_calibration::save_cell(path_, example());
  const Cell loaded = scan_calibration::load_cell(path_);
  EXPECT_EQ(loaded.base_link_in_world.translation(), example().base_link_in_world.translation());
  EXPECT_TRUE(loaded.base_link_in_world.isApprox(example().base_link_in_world, 1e-15));
  EXPECT_TRUE(loaded.tool_tip_in_tool0.isApprox(example().tool_tip_in_tool0, 1e-15));
}

TEST_F(CellFile, IsRefusedWithTheNameOfTheBadEntry) {
  EXPECT_EQ(complaint(std::string(kBase) + kTool), "nothing");
  EXPECT_EQ(complaint(kBase), ": tool_tip_in_tool0: missing (line 1); add it");
  EXPECT_EQ(complaint(std::string(kBase) + kTool + "tool: 1"),
            ": tool: no such entry (line 3); check its spelling");
  EXPECT_EQ(complaint(std::string(kBase) + "tool_tip_in_tool0: {translation: [0, 0], rotation: "
                                           "[0, 0, 0, 1]}"),
            ": tool_tip_in_tool0.translation: 2 numbers (line 2); give 3");
  EXPECT_EQ(complaint(std::string(kTool) + "base_link_in_world: {translation: [0, 0, 0]}"),
            ": base_link_in_world.rotation: missing (line 2); add it");
  EXPECT_THROW(scan_calibration::load_cell("/no/such/cell.yaml"), scan_cell_common::FileError);
}

TEST_F(CellFile, KeepsTheOtherEntryWhereOneIsUpdated) {
  scan_calibration::update_cell_entry(path_, "tool_tip_in_tool0", example().tool_tip_in_tool0);
  EXPECT_THROW(scan_calibration::load_cell(path_), scan_cell_common::UnusableInput);
  scan_calibration::update_cell_entry(path_, "base_link_in_world", example().base_link_in_world);
  const Cell loaded = scan_calibration::load_cell(path_);
  EXPECT_TRUE(loaded.base_link_in_world.isApprox(example().base_link_in_world, 1e-15));
  EXPECT_TRUE(loaded.tool_tip_in_tool0.isApprox(example().tool_tip_in_tool0, 1e-15));
}

TEST_F(CellFile, IsNotOverwrittenWhereItCannotBeRead) {
  const std::string text = "camera: mine";
  EXPECT_THROW(scan_calibration::update_cell_entry(write(text), "tool_tip_in_tool0", {}),
               scan_cell_common::UnusableInput);
  std::ifstream file(path_);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), text);
}

TEST_F(TaughtPosesFile, GivesPointsOrPoses) {
  const TaughtPoses points =
      scan_calibration::load_taught_poses(write("# taught\nx,y,z\n1,2,3\r\n\n4,5,-6e-3\n"));
  EXPECT_FALSE(points.has_orientation);
  ASSERT_EQ(points.poses.size(), 2U);
  EXPECT_EQ(points.poses[1].translation(), Eigen::Vector3d(4, 5, -6e-3));

  const TaughtPoses poses =
      scan_calibration::load_taught_poses(write("x,y,z,qx,qy,qz,qw\n1,2,3,1,0,0,0\n"));
  EXPECT_TRUE(poses.has_orientation);
  EXPECT_TRUE((poses.poses[0].linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
}

TEST_F(TaughtPosesFile, IsRefusedWithTheNumberOfTheBadLine) {
  EXPECT_EQ(complaint("x,y,z\n1,2,3\n1,2\n"), ": line 3: 2 values; give 3, as in the header");
  EXPECT_EQ(complaint("x,y,z\n1,2,wide\n"), ": line 2: 'wide'; give a number");
  EXPECT_EQ(complaint("x,y,z\n1,2,nan\n"), ": line 2: 'nan'; give a number");
  EXPECT_EQ(complaint("1,2,3\n").find(": line 1: '1,2,3'; begin with the header"), 0U);
  EXPECT_EQ(complaint("x,y,z,qx,qy,qz,qw\n1,2,3,1,1,0,0\n").find(": line 2: a quaternion"), 0U);
  EXPECT_THROW(scan_calibration::load_taught_poses("/no/such.csv"), scan_cell_common::FileError);
}

TEST_F(TaughtPosesFile, TakesMillimetresAndDegreesAsC4gShowsThem) {
  const TaughtPoses taught = scan_calibration::load_taught_poses(
      write("x_mm, y_mm, z_mm, a_deg, e_deg, r_deg\n# above the board\n850,-20,640,0,180,0\n"
            "850,-20,640,90,90,0\n"));
  ASSERT_EQ(taught.poses.size(), 2U);
  EXPECT_EQ(taught.lines, (std::vector<int>{3, 4}));
  EXPECT_TRUE(taught.poses[0].translation().isApprox(Eigen::Vector3d(0.85, -0.02, 0.64), 1e-12));
  EXPECT_TRUE((taught.poses[0].linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  // Rz(90) Ry(90): the tool looks along base y.
  EXPECT_TRUE((taught.poses[1].linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(Eigen::Vector3d::UnitY(), 1e-12));
}

TEST_F(TaughtPosesFile, SaysWhereTheNumbersBelieTheUnitsOfTheHead) {
  const std::string wire = "x_mm,y_mm,z_mm,a_deg,e_deg,r_deg\n";
  const std::string metres = "x,y,z,qx,qy,qz,qw\n";
  EXPECT_NE(complaint(wire + "850,-20,640,0.1,3.14,0\n").find("looks like radians"),
            std::string::npos);
  EXPECT_NE(complaint(wire + "0.85,-0.02,0.64,10,175,0\n").find("looks like metres"),
            std::string::npos);
  EXPECT_NE(complaint(metres + "0.85,0,0.6,10,175,0,0\n").find("looks like angles in degrees"),
            std::string::npos);
  EXPECT_NE(complaint(metres + "850,-20,640,0,0,0,1\n").find("looks like millimetres"),
            std::string::npos);
  EXPECT_NE(complaint("x,y,z\n850,-20,640\n").find("looks like millimetres"), std::string::npos);
  EXPECT_NE(complaint("850,-20,640,10,175,0\n").find("begin with the header"), std::string::npos);
}

TEST_F(TaughtPosesFile, NamesThePoseThatIsRepeated) {
  EXPECT_EQ(complaint("x,y,z,qx,qy,qz,qw\n1,2,3,0,0,0,1\n1,2,4,0,0,0,1\n1,2,3,0,0,0,1\n"),
            ": line 4: repeats the pose of line 2; leave one out or teach another pose");
}

TEST_F(TaughtPosesFile, GrowsByAPoseAndKeepsWhatStoodInIt) {
  const Eigen::Isometry3d first =
      Eigen::Translation3d(0.1, -0.2, 1.0 / 3) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitY());
  const Eigen::Isometry3d second = first * Eigen::Translation3d(0, 0, 0.1);
  fs::remove(path_);
  EXPECT_EQ(scan_calibration::append_taught_pose(path_, first), 1U);
  std::ofstream(path_, std::ios::app) << "# by hand, without a line's end";
  EXPECT_EQ(scan_calibration::append_taught_pose(path_, second), 2U);
  const TaughtPoses taught = scan_calibration::load_taught_poses(path_);
  ASSERT_EQ(taught.poses.size(), 2U);
  EXPECT_TRUE(taught.poses[0].isApprox(first, 1e-15));
  EXPECT_TRUE(taught.poses[1].isApprox(second, 1e-15));
  EXPECT_EQ(taught.lines, (std::vector<int>{2, 4})) << "the comment is still there";
}

TEST_F(TaughtPosesFile, DoesNotTakeTheSamePoseTwice) {
  fs::remove(path_);
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  scan_calibration::append_taught_pose(path_, pose);
  const std::string before = scan_cell_common::read_file(path_);
  EXPECT_THROW(scan_calibration::append_taught_pose(path_, pose), scan_cell_common::UnusableInput);
  EXPECT_EQ(scan_cell_common::read_file(path_), before);
}

TEST_F(TaughtPosesFile, TakesNoPoseWhereItIsAnotherFile) {
  for (const char* const text : {"", "x,y,z\n0,0,1\n", "poem\n"}) {
    write(text);
    EXPECT_THROW(scan_calibration::append_taught_pose(path_, Eigen::Isometry3d::Identity()),
                 scan_cell_common::UnusableInput);
    EXPECT_EQ(scan_cell_common::read_file(path_), text);
  }
}
