// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_line_targets.h"

#include <algorithm>

#include "scan_cell/videe_command.h"
#include "scan_cell_common/errors/errors.h"

namespace {

using namespace scan_cell_common;

/// Checks the complaint about a bad line, which goes back to the client as a line.
void check_complaint(const Error& error) {
  const std::string text = error.what();
  promise(text.size() < 400, "a complaint of " + std::to_string(text.size()) + " bytes");
  const auto control = [](char byte) { return static_cast<unsigned char>(byte) < ' '; };
  promise(std::none_of(text.begin(), text.end(), control), "control characters in a complaint");
}

void check_pose(const Eigen::Isometry3d& pose) {
  constexpr double kReach = 1e3;  // [m]
  promise(pose.translation().cwiseAbs().maxCoeff() <= kReach, "a pose out of this world");
  const Eigen::Matrix3d& rotation = pose.linear();
  const double off = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  promise(off < 1e-9 && rotation.determinant() > 0, "not a rotation");
  const Eigen::Isometry3d back = scan_cell::pose_from_wire(scan_cell::pose_to_wire(pose));
  promise((back.matrix() - pose.matrix()).cwiseAbs().maxCoeff() < 1e-5, "another pose came back");
}

void read_line(const std::string& line) {
  using Kind = scan_cell::VideeCommandKind;
  try {
    const scan_cell::VideeCommand command = scan_cell::parse_videe(line);
    const std::size_t poses = command.poses.size();
    const bool positions = command.kind == Kind::kSetPosition;
    promise(positions ? poses > 0 && poses % 2 == 0 : poses == 0, "start and end of each pass");
    for (const Eigen::Isometry3d& pose : command.poses)
      check_pose(pose);
  } catch (const Error& error) {
    check_complaint(error);
    throw;
  }
}

}  // namespace

std::vector<FuzzTarget> videe_line_targets() {
  FuzzTarget lines;
  lines.name = "videe";
  lines.run = read_line;
  lines.seeds = {"INIT_CYCLE",
                 "INIT_CALIBRATION",
                 "PERFORM_CALIBRATION",
                 "GRAB_IMAGE",
                 "SET_POSITION 800,-200,600,180,0,0 800,200,600,180,0,0",
                 "SET_POSITION 800.5,-200.25,6e2,+180,-0.001,1e-3 -999999,0,0,1080,90,-90",
                 "SET_POSITION 800,-200,600,180,0,0 800,200,600,180,0,0 "
                 "800,0,600,180,0,0 900,0,600,180,0,0",
                 "START_SCAN",
                 "STOP_SCAN",
                 "WAIT_SCAN",
                 "RESET"};
  lines.words = {"INIT_CYCLE",
                 "SET_POSITION",
                 "START_SCAN",
                 "STOP_SCAN",
                 "RESET",
                 "GRAB_IMAGE",
                 " ",
                 "\t",
                 "\r",
                 ",",
                 ",,",
                 "1,2,3,4,5,6",
                 "1,2,3,4,5,6,",
                 "1000001",
                 "-90",
                 "90"};
  return {lines};
}
