// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "session/session_targets.h"

#include <cmath>
#include <set>

#include "scan_calibration/session.h"
#include "scan_calibration/taught_poses.h"
#include "tecnogamma_camera/peak_file.h"

namespace {

using namespace scan_cell_common;
using namespace scan_calibration;

void expect_pose(const Eigen::Isometry3d& pose) {
  promise((pose.linear() * pose.linear().transpose()).isIdentity(1e-9), "a rotation");
  promise(pose.translation().norm() < 1000, "a place within reach");
}

FuzzTarget head_target() {
  FuzzTarget target;
  target.name = "session_head";
  target.seeds = {
      "images: poses.csv\nboard: {type: checkerboard, inner_corners: [7, 6], square_size: 0.010}\n"
      "lasers: [laser_0]\n",
      "# two\nimages: p\nboard:\n  type: checkerboard\n  inner_corners: [15, 25]\n"
      "  square_size: 2e-2\nlasers:\n  - laser_0\n  - laser_1\n"};
  target.words = {"images", "board", "inner_corners", "lasers", "laser_", "[",   "]", "{", "}",
                  "- ",     ": ",    "&p ",           "*p",     ".nan",   ".inf"};
  target.run = [](const std::string& bytes) {
    const SessionHead head = parse_session_head(bytes, "session.yaml");
    promise(!head.poses_file.empty(), "a file of poses");
    promise(head.board.columns >= 3 && head.board.rows >= 3, "a board");
    promise(head.board.square_size > 0 && head.board.square_size < 1, "squares");
    for (const std::string& laser : head.lasers)
      promise(laser.find("laser_") == 0, "a laser's name");
    promise(
        std::set<std::string>(head.lasers.begin(), head.lasers.end()).size() == head.lasers.size(),
        "each laser once");
  };
  return target;
}

FuzzTarget poses_target() {
  FuzzTarget target;
  target.name = "session_poses";
  target.seeds = {
      "image,x,y,z,qx,qy,qz,qw\nimages/1.png,1.36,0.03,1.48,0.0181,0.6639,-0.0031,0.7475\n"
      "images/2.png,1.43,0.19,1.46,0,0,0,1\n",
      "# c\nimage,x,y,z,qx,qy,qz,qw,laser_0\n1.png,1,0,0,0,0,0,1,1.csv\n2.png,1,0,0,1,0,0,0,\n"
      "3.png,1,0,0,1,0,0,0,3.png\n"};
  target.words = {",", "\n", "#", "nan", "inf", "1e308", "image", "laser_0", "laser_1", "-", "\r"};
  target.run = [](const std::string& bytes) {
    std::set<std::string> images;
    for (const SessionView& view : parse_session_poses(bytes, "poses.csv", {"laser_0"})) {
      expect_pose(view.base_to_flange);
      promise(!view.board_image.empty(), "an image");
      promise(images.insert(view.board_image).second, "an image of its own");
      promise(view.lines.size() == 1, "an entry a laser");
    }
  };
  return target;
}

FuzzTarget taught_target() {
  FuzzTarget target;
  target.name = "taught_poses";
  target.seeds = {"x,y,z\n1,2,3\n4,5,6\n", "x,y,z,qx,qy,qz,qw\n1,2,3,0,0,0,1\n1,2,4,0,0,0,1\n",
                  "# C4G\nx_mm,y_mm,z_mm,a_deg,e_deg,r_deg\n850.5,-20,640,10,175,-90\n"
                  "850,20,640,15,165,-80\n"};
  target.words = {",", "\n", "#", "nan", "inf", "1e308", "x_mm", "a_deg", "qx", "-", "\r"};
  target.run = [](const std::string& bytes) {
    const TaughtPoses taught = parse_taught_poses(bytes, "poses.csv");
    promise(taught.lines.size() == taught.poses.size(), "a line a pose");
    for (const Eigen::Isometry3d& pose : taught.poses)
      expect_pose(pose);
  };
  return target;
}

FuzzTarget peaks_target() {
  FuzzTarget target;
  target.name = "peaks";
  target.seeds = {"row,position,width,intensity\n4,10.2500,3.00,200.0\n6,10.5,3,255\n"};
  target.words = {",", "\n", "#", "nan", "inf", "1e308", "65535", "-1"};
  target.run = [](const std::string& bytes) {
    const auto profile = tecnogamma_camera::parse_peaks(bytes, "peaks.csv");
    promise(profile.first_row >= 0 && profile.rows() <= 65536, "rows of an image");
    promise(profile.width.size() == profile.position.size(), "a width a peak");
    promise(profile.intensity.size() == profile.position.size(), "an intensity a peak");
  };
  return target;
}

}  // namespace

std::vector<FuzzTarget> session_targets() {
  return {head_target(), poses_target(), taught_target(), peaks_target()};
}
