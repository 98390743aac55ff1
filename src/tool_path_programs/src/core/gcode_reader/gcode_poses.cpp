// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "gcode_reader/gcode_machine.h"
#include "gcode_reader/gcode_reader.h"
#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

/// Follows a program as the machine does, before and after the change. An axis that a line does not
/// name is where an earlier line left it; if that changed, the axis gets a word.
class Rewriting {
 public:
  Rewriting(const ProgramText& text, const std::vector<Eigen::Isometry3d>& poses)
      : text_(text),
        poses_(poses),
        dialect_(text.dialect),
        machine_(text.files[0], dialect_, no_calls_),
        said_(GcodeAxes::Constant(NAN)) {}

  std::vector<TextEdit> run(const std::vector<GcodeBlock>& blocks) {
    for (const GcodeBlock& block : blocks) {
      if (machine_.has_ended()) break;
      const GcodeAction action = machine_.run(gcode_without_calls(block));
      if (action.kind == GcodeAction::Kind::kIncomplete) pass(block);
      if (action.kind == GcodeAction::Kind::kMove) rewrite(block, action);
    }
    return std::move(edits_);
  }

 private:
  /// For lines that stay as they are.
  void pass(const GcodeBlock& block) {
    const bool own_places =
        std::any_of(block.words.begin(), block.words.end(), [](const GcodeWord& word) {
          return word.letter == 'G' && (word.value == 28 || word.value == 30 || word.value == 53);
        });
    bool has_axes = false;
    for (const GcodeWord& word : block.words) {
      const std::size_t axis = kPoseLetters.find(word.letter);
      if (axis == std::string::npos) continue;
      has_axes = true;
      said_[static_cast<Eigen::Index>(axis)] = own_places ? NAN : value_of(word, axis);
    }
    if (own_places && !has_axes) said_.setConstant(NAN);
  }

  void rewrite(const GcodeBlock& block, const GcodeAction& action) {
    const Eigen::Isometry3d& pose = poses_.at(pose_);
    const Eigen::Isometry3d& old = text_.poses.at(pose_).pose;
    const bool same = (pose.matrix() - old.matrix()).cwiseAbs().maxCoeff() <= kSamePose;
    const GcodeAxes axes = same ? action.to : dialect_.axes(pose, action.to);
    ++pose_;
    const bool moves = (axes - action.to).cwiseAbs().maxCoeff() > kSame;
    const bool began_moved = std::exchange(moved_, moves);
    if (action.via) {
      if (moves || began_moved) refuse_arc(block);
      return pass(block);
    }
    std::size_t end = block.words.front().offset;
    for (const GcodeWord& word : block.words)
      if (kPoseLetters.find(word.letter) != std::string::npos || word.letter == 'G')
        end = word.number_offset + word.number_length;
    std::string added;
    for (const Eigen::Index axis : dialect_.axes()) {
      const char letter = kPoseLetters[static_cast<std::size_t>(axis)];
      if (const GcodeWord* word = block.find(letter))
        replace(*word, axis, axes[axis]);
      else if (!(std::abs(axes[axis] - said_[axis]) <= kSame))
        added += ' ' + std::string(1, letter) + text_of("", axis, axes[axis]);
    }
    if (!added.empty()) edits_.push_back({0, end, 0, added});
  }

  [[noreturn]] void refuse_arc(const GcodeBlock& block) const {
    throw scan_cell_common::UnusableInput(
        text_.files[0].name + ", line " + std::to_string(block.line),
        "an arc (G2, G3) whose ends are to move", "write it as lines");
  }

  void replace(const GcodeWord& word, Eigen::Index axis, double value) {
    said_[axis] = value;
    if (std::abs(value_of(word, static_cast<std::size_t>(axis)) - value) <= kSame) return;
    const std::string old = text_.files[0].text.substr(word.number_offset, word.number_length);
    const std::string text = text_of(old, axis, value);
    if (text != old) edits_.push_back({0, word.number_offset, word.number_length, text});
  }

  std::string text_of(const std::string& old, Eigen::Index axis, double value) {
    said_[axis] = value;
    return like(old, axis > 2 ? value : value / machine_.unit(), machine_.digits(axis));
  }

  double value_of(const GcodeWord& word, std::size_t axis) const {
    return axis < 3 ? word.value * machine_.unit() : word.value;
  }

  static constexpr double kSame = 1e-6;      // [mm], [degrees]
  static constexpr double kSamePose = 1e-9;  // [m], and elements of a rotation matrix
  const ProgramText& text_;
  const std::vector<Eigen::Isometry3d>& poses_;
  const GcodeDialect dialect_;
  const std::set<std::string> no_calls_;
  GcodeMachine machine_;
  GcodeAxes said_;  // where the axes are in the changed program
  std::size_t pose_ = 0;
  bool moved_ = false;  // the pose before moved
  std::vector<TextEdit> edits_;
};

}  // namespace

std::vector<TextEdit> edits_of_gcode(const ProgramText& text,
                                     const std::vector<Eigen::Isometry3d>& poses) {
  return Rewriting(text, poses).run(gcode_blocks(text.files.at(0)));
}

}  // namespace tool_path_programs
