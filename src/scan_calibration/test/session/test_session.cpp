// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scan_calibration/session.h"
#include "scan_calibration/session_recorder.h"
#include "scan_cell_common/errors/errors.h"

namespace fs = std::filesystem;
using namespace scan_calibration;

namespace {

const char* const kHead =
    "images: poses.csv\n"
    "board: {type: checkerboard, inner_corners: [7, 6], square_size: 0.010}\n"
    "lasers: [laser_0]\n";
const char* const kPose = ",1,2,0.5,0,0,0,1";
const char* const kColumns = "image,x,y,z,qx,qy,qz,qw";

template <class Parse>
std::string complaint(const Parse& parse) {
  try {
    parse();
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "nothing";
}

std::string head_complaint(const std::string& text) {
  return complaint([&] { parse_session_head(text, "s"); });
}

std::string poses_complaint(const std::string& text, const std::vector<std::string>& lasers) {
  return complaint([&] { parse_session_poses(text, "p", lasers); });
}

class SessionFolder : public testing::Test {
 protected:
  void TearDown() override { fs::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_ = fs::temp_directory_path() / ("session_" + std::to_string(getpid()));
};

cv::Mat grey(int columns, int rows) {
  return cv::Mat(rows, columns, CV_8UC1, cv::Scalar(7));
}

}  // namespace

TEST(SessionHead, SaysBoardAndLasers) {
  const SessionHead head = parse_session_head(kHead, "s");
  EXPECT_EQ(head.poses_file, "poses.csv");
  EXPECT_EQ(head.board.columns, 7);
  EXPECT_EQ(head.board.rows, 6);
  EXPECT_DOUBLE_EQ(head.board.square_size, 0.01);
  EXPECT_EQ(head.lasers, std::vector<std::string>{"laser_0"});
}

TEST(SessionHead, IsRefusedWithTheEntryAndTheCure) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kHead;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(head_complaint(with("images: ", "image: ")),
            "s: image: no such entry (line 1); check its spelling");
  EXPECT_EQ(head_complaint(with("0.010", "10")),
            "s: board.square_size: 10 m (line 2); give metres: this looks like millimetres");
  EXPECT_EQ(head_complaint(with("0.010", "-1")),
            "s: board.square_size: -1 m (line 2); give metres, above 0");
  EXPECT_EQ(head_complaint(with("0.010", ".nan")).find("s: board.square_size: nan"), 0U);
  EXPECT_EQ(head_complaint(with("[7, 6]", "[7]")),
            "s: board.inner_corners: 1 numbers (line 2); give two: [columns, rows]");
  EXPECT_EQ(head_complaint(with("[7, 6]", "[7, 1]")).find("s: board.inner_corners"), 0U);
  EXPECT_EQ(head_complaint(with("[7, 6]", "[7.5, 6]")).find("s: board.inner_corners"), 0U);
  EXPECT_EQ(head_complaint(with("checkerboard", "charuco")),
            "s: board.type: 'charuco' (line 2); give checkerboard");
  EXPECT_NE(head_complaint(with("[laser_0]", "[laser_1, laser_0]")).find("in rising order"),
            std::string::npos);
  EXPECT_NE(head_complaint(with("[laser_0]", "[laser_0, laser_0]")).find("name each once"),
            std::string::npos);
  EXPECT_EQ(head_complaint(with("[laser_0]", "[laser_b]")),
            "s: lasers[0]: 'laser_b' (line 3); name lasers laser_0, laser_1");
}

TEST(SessionPoses, TakeTheLineFromTheBoardImageWhereNoColumnNamesAnother) {
  const auto views =
      parse_session_poses(std::string(kColumns) + "\na.png" + kPose + "\n", "p", {"laser_0"});
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(views[0].name, "a.png");
  EXPECT_EQ(views[0].lines, std::vector<std::string>{"a.png"});
  EXPECT_EQ(views[0].base_to_flange.translation(), Eigen::Vector3d(1, 2, 0.5));
}

TEST(SessionPoses, NameAnImageOrPeaksOfEachLaserOrNone) {
  const auto views = parse_session_poses(std::string(kColumns) + ",laser_1,laser_0\na.png" + kPose +
                                             ",b.png,c.csv\nd.png,1,2,3,0,0,0,1,,e.png\n",
                                         "p", {"laser_0", "laser_1"});
  ASSERT_EQ(views.size(), 2U);
  EXPECT_EQ(views[0].lines, (std::vector<std::string>{"c.csv", "b.png"}));
  EXPECT_EQ(views[1].lines, (std::vector<std::string>{"e.png", ""}));
}

TEST(SessionPoses, AreRefusedWithTheLineAndTheCure) {
  const std::string columns = std::string(kColumns) + "\n";
  const std::string pose = kPose;
  EXPECT_EQ(poses_complaint("", {"laser_0"}), "p: empty; begin with image,x,y,z,qx,qy,qz,qw");
  EXPECT_EQ(
      poses_complaint("name,x,y,z,qx,qy,qz,qw\n", {"laser_0"}).find("p: line 1: wrong header"), 0U);
  EXPECT_EQ(poses_complaint(std::string(kColumns) + ",laser_2\n", {"laser_0"}),
            "p: line 1: column 'laser_2'; name each laser of session.yaml once, and nothing else");
  EXPECT_EQ(poses_complaint(std::string(kColumns) + ",laser_0,laser_0\n", {"laser_0"})
                .find("p: line 1: column 'laser_0'"),
            0U);
  EXPECT_EQ(poses_complaint(columns, {"laser_0", "laser_1"}),
            "p: line 1: columns for 0 of 2 lasers; add a column for each laser: several lines in "
            "one image cannot be told apart");
  EXPECT_EQ(poses_complaint(columns + "a.png" + pose + "\na.png,1,2,4,0,0,0,1\n", {"laser_0"}),
            "p: line 3: 'a.png' repeated, first in line 2; give each view files of its own");
  EXPECT_EQ(poses_complaint(columns + pose + "\n", {"laser_0"}),
            "p: line 2: no image; name the image that shows the board");
  EXPECT_EQ(poses_complaint(columns + "a.png,1,2\n", {"laser_0"}),
            "p: line 2: 3 values; give 8, as in the header");
  EXPECT_NE(
      poses_complaint(columns + "a.png,1,2,3,10,170,5,0\n", {"laser_0"}).find("angles in degrees"),
      std::string::npos);
  EXPECT_NE(
      poses_complaint(columns + "a.png,1360,33,1481,0,0,0,1\n", {"laser_0"}).find("millimetres"),
      std::string::npos);
}

TEST_F(SessionFolder, NamesTheMissingImage) {
  fs::create_directories(folder_);
  EXPECT_THROW(load_session(folder_.string()), scan_cell_common::FileError);
  std::ofstream(path("session.yaml")) << kHead;
  EXPECT_THROW(load_session(folder_.string()), scan_cell_common::FileError);
  std::ofstream(path("poses.csv")) << kColumns << "\nimages/a.png" << kPose << "\n";
  EXPECT_EQ(complaint([&] { load_session(folder_.string()); }),
            path("poses.csv") + ": images/a.png: no file " + path("images/a.png") +
                "; restore it or remove the line");
}

TEST_F(SessionFolder, ComesBackAsItWasRecorded) {
  const Board board{15, 25, 0.02};
  const Eigen::Isometry3d pose = Eigen::Translation3d(1.0 / 3, -2, 0.1) *
                                 Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized());
  SessionRecorder recorder(folder_.string(), board, {"laser_0", "laser_1"});
  tecnogamma_camera::PeakProfile peaks;
  peaks.clear(4, 3);
  peaks.position[1] = 10.25F;
  peaks.width[1] = 3;
  peaks.intensity[1] = 200;
  recorder.add(pose, grey(8, 6), {{grey(8, 6), {}, false}, {{}, peaks, false}});
  const Session first = load_session(folder_.string());
  ASSERT_EQ(first.views.size(), 1U) << "a session after each view";
  recorder.add(pose, grey(8, 6), {{}, {}});

  const Session session = load_session(folder_.string());
  EXPECT_EQ(session.board.columns, 15);
  EXPECT_EQ(session.board.rows, 25);
  EXPECT_EQ(session.board.square_size, 0.02);
  ASSERT_EQ(session.views.size(), 2U);
  EXPECT_EQ(session.views[0].base_to_flange.translation(), pose.translation());
  EXPECT_TRUE(session.views[0].base_to_flange.isApprox(pose, 1e-15));
  EXPECT_EQ(session.views[0].lines[1], path("images/laser_1_0001.csv"));
  EXPECT_EQ(session.views[1].lines, (std::vector<std::string>{"", ""}));
}

TEST_F(SessionFolder, IsNeverRecordedOverAndStaysWholeWhereAViewCannotBeWritten) {
  const Board board{7, 6, 0.01};
  SessionRecorder recorder(folder_.string(), board, {"laser_0"});
  EXPECT_THROW(recorder.add(Eigen::Isometry3d::Identity(), {}, {{}}),
               scan_cell_common::UnusableInput);
  EXPECT_FALSE(fs::exists(path("session.yaml")));
  recorder.add(Eigen::Isometry3d::Identity(), grey(4, 4), {{}});
  EXPECT_THROW(recorder.add(Eigen::Isometry3d::Identity(), grey(4, 4), {}),
               scan_cell_common::UnusableInput);
  fs::remove_all(path("images"));
  std::ofstream(path("images")) << "in the way";
  EXPECT_THROW(recorder.add(Eigen::Isometry3d::Identity(), grey(4, 4), {{}}),
               scan_cell_common::FileError);
  EXPECT_EQ(recorder.views(), 1);
  EXPECT_EQ(parse_session_poses(
                [&] {
                  std::ifstream file(path("poses.csv"));
                  return std::string(std::istreambuf_iterator<char>(file), {});
                }(),
                "p", {"laser_0"})
                .size(),
            1U);
  EXPECT_THROW(SessionRecorder(folder_.string(), board, {"laser_0"}), scan_cell_common::Refused);
  const std::string too_long = path(std::string(300, 'x'));  // longer than a file system's names
  EXPECT_THROW(SessionRecorder(too_long, board, {"laser_0"}), scan_cell_common::FileError);
}

TEST(SessionHead, NamesSomeOfTheLasersOrNone) {
  const std::string board =
      "images: p\nboard: {type: checkerboard, inner_corners: [7, 6], square_size: 0.01}\n";
  EXPECT_EQ(parse_session_head(board + "lasers: [laser_1]\n", "s").lasers,
            std::vector<std::string>{"laser_1"});
  EXPECT_TRUE(parse_session_head(board + "lasers: []\n", "s").lasers.empty());
  const auto views = parse_session_poses(std::string(kColumns) + "\na.png" + kPose + "\n", "p", {});
  ASSERT_EQ(views.size(), 1U);
  EXPECT_TRUE(views[0].lines.empty());
}

TEST_F(SessionFolder, HoldsTheBoardAlone) {
  const Board board{15, 25, 0.02};
  SessionRecorder recorder(folder_.string(), board, {});
  recorder.add(Eigen::Isometry3d::Identity(), cv::Mat(8, 6, CV_8UC1, cv::Scalar(7)), {});
  const auto session = scan_calibration::load_session(folder_.string());
  EXPECT_TRUE(session.lasers.empty());
  ASSERT_EQ(session.views.size(), 1U);
  EXPECT_TRUE(session.views[0].lines.empty());
}
