// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid/rapid_frames.h"

#include <fmt/format.h>

#include <algorithm>

#include "rapid/rapid_move_text.h"
#include "rapid/rapid_names.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;
using scan_cell_common::UnusableInput;

bool same(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return one.isApprox(other, 1e-12);
}

}  // namespace

RapidFrames::RapidFrames(const Program& program) : program_(program) {
  for (const Frames& frames : program.frames) {
    std::string text = name_of(frames.tool, true);
    const std::string user = name_of(frames.user, false);
    if (!user.empty()) text += "\\WObj:=" + user;
    arguments_.push_back(text);
  }
}

std::string RapidFrames::name_of(const Frame& frame, bool tool) {
  const std::string thing = tool ? "tool" : "work object";
  if (frame.name.empty() && !frame.pose) {
    if (tool)
      throw UnusableInput("RAPID, tool", "neither name nor pose, and each move names its tool",
                          "give its name on the controller, or a cell file; tool0 is the flange");
    note("no work object is named: the poses are in wobj0, the controller's world frame");
    return "";
  }
  std::string name = frame.name;
  if (name.empty()) {
    const auto same_pose = std::find_if(declared_.begin(), declared_.end(), [&](const auto& other) {
      return other.first.front() == (tool ? 't' : 'w') && same(other.second, *frame.pose);
    });
    if (same_pose != declared_.end()) return same_pose->first;
    name = fmt::format("{}_{}{}", tool ? "t" : "w", program_.name,
                       declared_.empty() ? "" : std::to_string(declared_.size()));
  }
  check_rapid_name(thing, name, kLongestRapidName);
  if (frame.pose)
    declare(name, *frame.pose, tool);
  else
    note(fmt::format("{} {} is the controller's", thing, name));
  return name;
}

void RapidFrames::declare(const std::string& name, const Eigen::Isometry3d& pose, bool tool) {
  const std::string key = lower_case(name);
  if (key == "tool0" || key == "wobj0") {
    if (same(pose, Eigen::Isometry3d::Identity())) return;
    throw UnusableInput(name, "predefined by RAPID, and not this pose", "give it another name");
  }
  for (const auto& [known, other] : declared_) {
    if (lower_case(known) != key) continue;
    if (same(other, pose)) return;
    throw UnusableInput(name, "two poses have this name", "give each frame its own name");
  }
  declared_.emplace_back(name, pose);
  const std::string text = rapid_pose(pose);
  if (!tool) {
    declarations_.push_back(fmt::format(
        "TASK PERS wobjdata {}:=[FALSE,TRUE,\"\",{},[[0,0,0],[1,0,0,0]]];", name, text));
    return;
  }
  declarations_.emplace_back("! The load is not known here: 1 kg stands for it.");
  declarations_.push_back(
      fmt::format("TASK PERS tooldata {}:=[TRUE,{},[1,[0,0,1],[1,0,0,0],0,0,0]];", name, text));
  note(fmt::format("tool {}: 1 kg stands for its load; put in what the controller identified",
                   name));
}

void RapidFrames::note(const std::string& note) {
  if (std::find(notes_.begin(), notes_.end(), note) == notes_.end()) notes_.push_back(note);
}

}  // namespace tool_path_programs
