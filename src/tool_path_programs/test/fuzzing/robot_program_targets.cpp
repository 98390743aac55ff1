// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "robot_program_targets.h"

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "tool_path_programs/adapted_program.h"

using namespace tool_path_programs;
using scan_cell_common::promise;

namespace {

/// Adapts the program to a part where no arc stays a circle.
void check_bent(const Language& language, const ProgramText& text, const ReadSettings& settings) {
  ProgramPathSettings path_settings;
  path_settings.arc_step = 0.05;
  path_settings.arc_chord_error = 0.01;
  path_settings.turns_by_via = language.turns_by_via();
  const ProgramPath path = path_of(text, path_settings);
  tool_paths::ToolPath bent = path.path;
  for (tool_paths::Segment& segment : bent.segments)
    for (tool_paths::Waypoint& waypoint : segment.waypoints)
      waypoint.pose.translation().z() += 1e-3 * std::sin(1e2 * waypoint.pose.translation().x());
  const AdaptedProgram adapted = adapted_program(language, text, settings, path, bent, 1e-6);
  const ProgramText again = language.read(adapted.files, settings);
  promise(again.steps.size() >= text.steps.size(), "nothing is lost");
  promise(adapted.notes.empty() == (again.steps.size() == text.steps.size()),
          "what became lines is told");
}

}  // namespace

void check_robot_program(const Language& language, const std::string& bytes,
                         const ReadSettings& settings) {
  const std::vector<SourceFile> files = {{"part" + language.extensions().front(), bytes}};
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
  try {
    check_bent(language, text, settings);
  } catch (const scan_cell_common::UnusableInput&) {
    // not every program read can be expressed on every part
  }
}

std::vector<scan_cell_common::FuzzTarget> robot_program_targets() {
  return {fanuc_target(), gcode_target(), krl_target(),
          pdl2_target(),  rapid_target(), urscript_target()};
}
