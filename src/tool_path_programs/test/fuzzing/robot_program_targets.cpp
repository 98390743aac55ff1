// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_program_targets.h"

#include "tool_path_programs/program_path.h"

using namespace tool_path_programs;
using scan_cell_common::promise;

void check_robot_program(const Language& language, const std::string& bytes,
                         const ReadSettings& settings) {
  const std::vector<SourceFile> files = {{"part" + language.endings().front(), bytes}};
  const ProgramText text = language.read(files, settings);
  promise(text.steps.size() == text.program.steps.size(), "each step has its place");
  std::vector<Eigen::Isometry3d> poses;
  for (const PoseText& pose : text.poses) {
    promise(pose.pose.matrix().allFinite(), "poses are finite");
    promise(pose.pose.linear().isUnitary(1e-6), "turns are turns");
    poses.push_back(pose.pose);
  }
  promise(edited(files, language.edits(text, poses)).front().text == bytes,
          "the same poses keep every byte");
  const Eigen::Isometry3d moved =
      Eigen::Translation3d(0.01, -0.002, 0.3) * Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY());
  for (Eigen::Isometry3d& pose : poses)
    pose = moved * pose;
  with_poses(language, text, settings, poses);
}

std::vector<scan_cell_common::FuzzTarget> robot_program_targets() {
  return {fanuc_target(), gcode_target(), krl_target(),
          pdl2_target(),  rapid_target(), urscript_target()};
}
