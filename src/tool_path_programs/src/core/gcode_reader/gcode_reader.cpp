// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_reader/gcode_reader.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "gcode_reader/gcode_machine.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

constexpr double kPerMinute = 1e-3 / 60;  // 1 mm/min in m/s

/// The dialect that has the axes of a program, if none is given.
std::string dialect_of(const std::vector<GcodeBlock>& blocks, const SourceFile& file) {
  std::set<char> rotary;
  for (const GcodeBlock& block : blocks)
    for (const GcodeWord& word : block.words)
      if (word.letter >= 'A' && word.letter <= 'C') rotary.insert(word.letter);
  if (rotary.empty()) return "xyz";
  if (rotary == std::set<char>{'A', 'C'}) return "xyzac";
  if (rotary == std::set<char>{'B', 'C'}) return "xyzbc";
  if (rotary == std::set<char>{'A', 'B', 'C'}) return "xyzabc";
  throw scan_cell_common::UnusableInput(file.name,
                                        "rotary axes " + std::string(rotary.begin(), rotary.end()),
                                        "give A B C, A C, B C or none, or say the dialect");
}

/// Whether the block has an M function that stops after the move.
bool has_end(const GcodeBlock& block) {
  const std::set<double> ends = {0, 1, 2, 30, 60};
  return std::any_of(block.words.begin(), block.words.end(), [&](const GcodeWord& word) {
    return word.letter == 'M' && ends.count(word.value) != 0;
  });
}

class Reader {
 public:
  Reader(const std::vector<SourceFile>& files, const ReadSettings& settings)
      : blocks_(gcode_blocks(files[0])),
        dialect_(settings.dialect.empty() ? dialect_of(blocks_, files[0]) : settings.dialect),
        settings_(settings),
        machine_(files[0], dialect_, settings.calls_without_motion) {
    text_.files = files;
    text_.dialect = dialect_.name();
    text_.program.name = std::filesystem::path(files[0].name).stem().string();
  }

  ProgramText run() {
    for (const GcodeBlock& block : blocks_) {
      if (machine_.has_ended()) break;
      const GcodeAction action = machine_.run(block);
      for (const SetOutput& output : action.outputs)
        add(output, block);
      if (action.kind == GcodeAction::Kind::kIncomplete) {
        add(JointMove{action.values}, block);
        before_.reset();
      } else if (action.kind == GcodeAction::Kind::kMove) {
        add_move(action, block);
      }
    }
    return std::move(text_);
  }

 private:
  void add(const Step& step, const GcodeBlock& block) {
    text_.program.steps.push_back(step);
    text_.steps.push_back({{0, block.line}, {}, {}});
  }

  void add_move(const GcodeAction& action, const GcodeBlock& block) {
    Move move;
    move.pose = dialect_.pose(action.to);
    move.zone = 1e-3 * machine_.tolerance();
    move.frames = frames();
    if (action.motion == 0) {
      move.kind = MotionKind::kJoint;
      move.joint_speed = 1;
    } else {
      move.speed = kPerMinute * machine_.feed();
    }
    if (action.via) {
      move.kind = MotionKind::kCircular;
      move.via = via_of(*action.via, move.pose);
    }
    add(move, block);
    text_.steps.back().pose = text_.poses.size();
    if (action.via && !has_end(block))
      text_.steps.back().arc = ArcText{gcode_range(block), {}, {}, {}, {}};
    text_.poses.push_back({move.pose, {0, block.line}, block.words.front().offset});
    before_ = move.pose;
  }

  /// The pose at the via: the tool turns evenly along an arc.
  Eigen::Isometry3d via_of(const Eigen::Vector3d& position, const Eigen::Isometry3d& to) const {
    Eigen::Isometry3d via = to;
    via.translation() = 1e-3 * position;
    if (before_)
      via.linear() = Eigen::Quaterniond(before_->linear())
                         .slerp(0.5, Eigen::Quaterniond(to.linear()))
                         .toRotationMatrix();
    return via;
  }

  std::size_t frames() {
    const auto [at, added] =
        frames_.try_emplace({machine_.tool(), machine_.user()}, text_.program.frames.size());
    if (added)
      text_.program.frames.push_back({{machine_.tool(), {}}, {machine_.user(), place_of_user()}});
    return at->second;
  }

  std::optional<Eigen::Isometry3d> place_of_user() const {
    const auto known = settings_.frames.find(machine_.user());
    return known == settings_.frames.end() ? std::nullopt : std::optional(known->second);
  }

  const std::vector<GcodeBlock> blocks_;
  const GcodeDialect dialect_;
  const ReadSettings& settings_;
  GcodeMachine machine_;
  ProgramText text_;
  std::map<std::pair<std::string, std::string>, std::size_t> frames_;  // tool, user
  std::optional<Eigen::Isometry3d> before_;
};

}  // namespace

ProgramText read_gcode(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  if (files.empty())
    throw scan_cell_common::UnusableInput("G-code program", "no file", "give the main file");
  const auto stem = [](const SourceFile& file) { return std::filesystem::path(file.name).stem(); };
  for (const SourceFile& file : files)  // same stem: another program found beside it
    if (stem(file) != stem(files[0]))
      throw scan_cell_common::UnusableInput(file.name, "a second file of a G-code program",
                                            "subroutines are not followed: write them out");
  return Reader(files, settings).run();
}

}  // namespace tool_path_programs
