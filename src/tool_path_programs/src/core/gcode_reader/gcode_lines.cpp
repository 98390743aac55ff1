// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>

#include "gcode_reader/gcode_machine.h"
#include "gcode_reader/gcode_reader.h"
#include "text/arc_statement.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

const std::string kArcLetters = "IJKRP";

bool is_motion(const GcodeWord& word) {
  return word.letter == 'G' && word.value >= 0 && word.value <= 3 &&
         word.value == static_cast<int>(word.value);
}

/// Follows a program as the machine does: what a line leaves out stays as it was.
class GcodeLines {
 public:
  GcodeLines(const ProgramText& text, const std::vector<ArcLines>& arcs)
      : text_(text), dialect_(text.dialect), machine_(text.files[0], dialect_, no_calls_) {
    for (const ArcLines& arc : arcs)
      arcs_[text.steps[arc.step].place.line] = &arc;
  }

  std::vector<TextEdit> run() {
    for (const GcodeBlock& block : gcode_blocks(text_.files[0])) {
      if (machine_.has_ended()) break;
      const GcodeAction action = machine_.run(gcode_without_calls(block));
      const auto arc = arcs_.find(block.line);
      if (arc != arcs_.end())
        say_lines(block, action.to, *arc->second);
      else if (changed_)
        say_motion(block, action);
      if (action.kind == GcodeAction::Kind::kMove) at_ = action.to;
    }
    return std::move(edits_);
  }

 private:
  /// Writes the motion word that an earlier arc, now removed, left in force.
  void say_motion(const GcodeBlock& block, const GcodeAction& action) {
    const bool is_said = std::any_of(block.words.begin(), block.words.end(), is_motion);
    if (!is_said && action.kind != GcodeAction::Kind::kMove) return;
    if (!is_said)
      edits_.push_back(
          {0, block.words.front().offset, 0, "G" + std::to_string(action.motion) + " "});
    changed_ = false;
  }

  /// The first line keeps all words but the coordinates.
  void say_lines(const GcodeBlock& block, const GcodeAxes& to, const ArcLines& arc) {
    std::vector<std::string> statements;
    GcodeAxes axes = at_;
    for (std::size_t i = 0; i < arc.poses.size(); ++i) {
      axes = dialect_.axes(arc.poses[i], axes);
      const std::string places = words_of(axes);
      statements.push_back(i == 0 ? first_line(block, arc.step, places) : "G1" + places);
    }
    const std::string end = end_words(block, to, arc.step);
    statements.push_back(arc.poses.empty() ? first_line(block, arc.step, end) : "G1" + end);
    edits_.push_back(in_place_of_arc(text_, arc.step, statements));
    changed_ = true;
  }

  /// The end's words as written, and those of axes that the lines before left elsewhere.
  std::string end_words(const GcodeBlock& block, const GcodeAxes& to, std::size_t step) const {
    const ArcStatement statement(text_, step);
    std::string words;
    for (const Eigen::Index axis : dialect_.axes()) {
      const GcodeWord* const word = block.find(kPoseLetters[static_cast<std::size_t>(axis)]);
      words +=
          word == nullptr
              ? word_of(axis, to)
              : " " + statement.piece({word->offset, word->number_offset + word->number_length});
    }
    return words;
  }

  std::string first_line(const GcodeBlock& block, std::size_t step,
                         const std::string& places) const {
    ArcStatement line(text_, step);
    bool has_motion = false;
    for (const GcodeWord& word : block.words) {
      ByteRange range{word.offset, word.number_offset + word.number_length};
      const bool goes = kPoseLetters.find(word.letter) != std::string::npos ||
                        kArcLetters.find(word.letter) != std::string::npos;
      if (is_motion(word)) line.put(range, "G1" + places);
      const bool is_first = word.offset == block.words.front().offset;
      if (goes && !is_first && text_.files[0].text[range.begin - 1] == ' ') --range.begin;
      if (goes) line.put(range, "");
      has_motion = has_motion || is_motion(word);
    }
    return (has_motion ? "" : "G1" + places) + line.text();
  }

  std::string words_of(const GcodeAxes& axes) const {
    std::string words;
    for (const Eigen::Index axis : dialect_.axes())
      words += word_of(axis, axes);
    return words;
  }

  std::string word_of(Eigen::Index axis, const GcodeAxes& axes) const {
    const double value = axis < 3 ? axes[axis] / machine_.unit() : axes[axis];
    return std::string(" ") + kPoseLetters[static_cast<std::size_t>(axis)] +
           fixed(value, machine_.digits(axis));
  }

  const ProgramText& text_;
  const GcodeDialect dialect_;
  const std::set<std::string> no_calls_;
  GcodeMachine machine_;
  std::map<std::size_t, const ArcLines*> arcs_;  // by line
  GcodeAxes at_ = GcodeAxes::Zero();
  bool changed_ = false;  // the motion word in force: G1 in place of an arc's
  std::vector<TextEdit> edits_;
};

}  // namespace

std::vector<TextEdit> lines_of_gcode(const ProgramText& text, const std::vector<ArcLines>& arcs) {
  return GcodeLines(text, arcs).run();
}

}  // namespace tool_path_programs
