// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_reader/gcode_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gcode_reader/gcode_arcs.h"
#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarthest = 1e6;  // [mm] or [degrees]

/// Ten times the number: 591 for G59.1.
int code_of(const GcodeWord& word) {
  return static_cast<int>(std::lround(10 * std::clamp(word.value, -1000.0, 1000.0)));
}

std::string name_of(const GcodeWord& word) {
  return word.letter + shortest(word.value, 3);
}

/// Whether a function neither moves nor changes the frame of positions: ends of modes that are
/// refused, tool lengths, feed and spindle modes, return planes.
bool is_without_effect(int code) {
  const std::set<int> codes = {400, 430, 434, 490, 690, 911, 940, 960, 970, 980, 990};
  return codes.count(code) != 0;
}

}  // namespace

GcodeMachine::GcodeMachine(const SourceFile& file, const GcodeDialect& dialect,
                           const std::set<std::string>& calls_without_motion)
    : file_(file),
      dialect_(dialect),
      calls_without_motion_(calls_without_motion),
      at_(GcodeAxes::Constant(kNotKnown)),
      feed_(kNotKnown) {}

GcodeAction GcodeMachine::run(const GcodeBlock& block) {
  block_ = &block;
  own_places_ = false;
  dwells_ = false;
  GcodeAction action;
  if (block.may_be_skipped) {
    if (has_axes()) fail("a move that may be skipped (/)", "give the program with or without it");
    return action;
  }
  for (const GcodeWord& word : block.words)
    if (word.letter == 'G') preparatory(word);
  set_modes();
  for (const GcodeWord& word : block.words)
    if (word.letter == 'M') miscellaneous(word, action);
  if (own_places_)
    move_to_own_places(action);
  else if (has_axes() && !dwells_)
    move(action);
  return action;
}

void GcodeMachine::preparatory(const GcodeWord& word) {
  const int code = code_of(word);
  if (code == 0 || code == 10 || code == 20 || code == 30) {
    motion_ = code / 10;
  } else if (code == 40) {
    dwells_ = true;
  } else if (code == 170 || code == 180 || code == 190) {
    normal_ = code == 170 ? 2 : code == 180 ? 1 : 0;
  } else if (code == 200 || code == 210) {
    inches_ = code == 200;
  } else if (code == 280 || code == 300 || code == 530) {
    own_places_ = true;
  } else if (code == 610 || code == 611) {
    tolerance_ = 0;
  } else if (code == 640) {
    const GcodeWord* tolerance = block_->find('P');
    tolerance_ = tolerance == nullptr ? 0 : tolerance->value * unit();
  } else if (code == 800) {
    motion_ = -1;
  } else if (code == 900 || code == 910) {
    incremental_ = code == 910;
  } else if (code >= 540 && code <= 593) {
    set_frame(code);
  } else if (!is_without_effect(code)) {
    fail(name_of(word), "this function is not followed: give the program written out in lines");
  }
}

void GcodeMachine::set_frame(int code) {
  const bool is_one = code % 10 == 0 || code > 590;
  if (!is_one) fail("G" + shortest(0.1 * code, 1), "give G54 to G59.3");
  user_ = "G" + shortest(0.1 * code, 1);
}

void GcodeMachine::set_modes() {
  const GcodeWord* feed = block_->find('F');
  if (feed != nullptr) feed_ = feed->value * unit();
  const GcodeWord* tool = block_->find('T');
  if (tool != nullptr) next_tool_ = shortest(tool->value, 3);
  const GcodeWord* length = block_->find('H');
  if (length != nullptr) tool_ = shortest(length->value, 3);
}

void GcodeMachine::miscellaneous(const GcodeWord& word, GcodeAction& action) {
  const int code = code_of(word);
  const auto outputs = [&](std::initializer_list<const char*> names, bool on) {
    for (const char* name : names)
      action.outputs.push_back({name, on});
  };
  if (code == 20 || code == 300) {
    ended_ = true;
  } else if (code == 60) {
    tool_ = next_tool_;
  } else if (code == 30 || code == 40 || code == 50) {
    outputs({"spindle"}, code != 50);
  } else if (code == 70 || code == 80) {
    outputs({code == 70 ? "mist" : "flood"}, true);
  } else if (code == 90) {
    outputs({"mist", "flood"}, false);
  } else if (code >= 620 && code <= 650 && code % 10 == 0) {
    const GcodeWord* output = block_->find('P');
    if (output == nullptr) fail(name_of(word) + " without P", "give the output's number");
    action.outputs.push_back({shortest(output->value, 3), code == 620 || code == 640});
  } else {
    const std::set<int> known = {0, 10, 480, 490, 660};  // stops, overrides, waits for an input
    if (known.count(code) == 0 && calls_without_motion_.count(name_of(word)) == 0)
      fail("calls " + name_of(word), "name it as a call without motion, if it is one");
  }
}

bool GcodeMachine::has_axes() const {
  return std::any_of(block_->words.begin(), block_->words.end(), [](const GcodeWord& word) {
    return kPoseLetters.find(word.letter) != std::string::npos || word.letter == 'U' ||
           word.letter == 'V' || word.letter == 'W' || word.letter == 'E';
  });
}

/// [mm] or [degrees]
double GcodeMachine::coordinate(const GcodeWord& word) const {
  const std::size_t axis = kPoseLetters.find(word.letter);
  if (axis == std::string::npos || !dialect_.has(static_cast<Eigen::Index>(axis)))
    fail(name_of(word) + ", an axis that " + dialect_.name() + " does not have",
         "give another dialect, or a program without it");
  const double value = axis < 3 ? word.value * unit() : word.value;
  if (!(std::abs(value) <= kFarthest)) fail(name_of(word), "give a place that a machine reaches");
  return value;
}

void GcodeMachine::move_to_own_places(GcodeAction& action) {
  action.kind = GcodeAction::Kind::kIncomplete;
  for (const GcodeWord& word : block_->words) {
    const std::size_t axis = kPoseLetters.find(word.letter);
    if (axis == std::string::npos) continue;
    action.values.push_back(word.value);
    at_[static_cast<Eigen::Index>(axis)] = kNotKnown;
  }
  if (action.values.empty()) at_.setConstant(kNotKnown);
}

void GcodeMachine::move(GcodeAction& action) {
  if (incremental_) fail("incremental positions (G91)", "give the program in absolute ones (G90)");
  if (motion_ < 0) fail("a move without G0, G1, G2 or G3", "give one of them before it");
  const GcodeAxes from = at_;
  for (const GcodeWord& word : block_->words) {
    const std::size_t axis = kPoseLetters.find(word.letter);
    if (axis == std::string::npos && std::string("UVWE").find(word.letter) == std::string::npos)
      continue;
    const double value = coordinate(word);
    at_[static_cast<Eigen::Index>(axis)] = value;
    action.values.push_back(word.value);
  }
  action.motion = motion_;
  action.to = at_;
  if (motion_ > 0 && !(feed_ > 0)) fail("a move without a feed (F)", "give a feed above 0");
  const bool complete = std::all_of(dialect_.axes().begin(), dialect_.axes().end(),
                                    [&](Eigen::Index axis) { return std::isfinite(at_[axis]); });
  action.kind = complete ? GcodeAction::Kind::kMove : GcodeAction::Kind::kIncomplete;
  if (complete) action.to = action.to.array().isNaN().select(0, action.to);
  if (motion_ > 1) arc(action, from);
}

void GcodeMachine::arc(GcodeAction& action, const GcodeAxes& from) const {
  GcodeArc arc;
  arc.normal = normal_;
  arc.clockwise = motion_ == 2;
  arc.from = from.head<3>();
  arc.to = action.to.head<3>();
  if (const GcodeWord* radius = block_->find('R')) arc.radius = radius->value * unit();
  const std::string letters = "IJK";
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const GcodeWord* word = block_->find(letters[i]);
    if (word == nullptr) continue;
    if (!arc.centre_from_start) arc.centre_from_start = Eigen::Vector3d::Zero();
    (*arc.centre_from_start)[static_cast<Eigen::Index>(i)] = word->value * unit();
  }
  const GcodeWord* turns = block_->find('P');
  if (arc.from.allFinite() && (turns == nullptr || turns->value == 1)) action.via = middle_of(arc);
  if (!action.via)
    fail("an arc from a place that is not known, a whole circle, a helix, or none at all",
         "give arcs of less than a turn in one plane, or lines");
}

int GcodeMachine::digits(Eigen::Index axis) const {
  constexpr int kMillimetre = 4, kInch = 6, kDegree = 5;
  if (axis > 2) return kDegree;
  return inches_ ? kInch : kMillimetre;
}

GcodeBlock gcode_without_calls(GcodeBlock block) {
  const auto is_call = [](const GcodeWord& word) {
    return word.letter == 'M' && word.value != 2 && word.value != 30;
  };
  block.words.erase(std::remove_if(block.words.begin(), block.words.end(), is_call),
                    block.words.end());
  return block;
}

void GcodeMachine::fail(const std::string& value, const std::string& cure) const {
  throw scan_cell_common::UnusableInput(file_.name + ", line " + std::to_string(block_->line),
                                        value, cure);
}

}  // namespace tool_path_programs
