// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>

#include "krl_values/krl_state.h"

namespace tool_path_programs {

/// Collects the steps of a program, motion by motion.
class KrlMotions {
 public:
  KrlMotions(ProgramText& text, const KrlVariables& variables, KrlSetter& setter)
      : text_(text), variables_(variables), setter_(setter) {}

  /// Reads a motion from after its keyword, such as lin, to the end of the line.
  void move(const std::string& word, const Place& place, TokenReader& reader);

  void set_output(const SetOutput& output, const Place& place);

  /// Notes a TRIGGER, whatever it does: it counts from the ends of the next motion.
  void trigger_at_next() { triggered_ = true; }

  /// Adds an output that a TRIGGER sets at the end of the next motion.
  void set_output_behind_next(const SetOutput& output, const Place& place);

 private:
  /// The target after LIN: a pose, or something else.
  struct Target {
    std::optional<KrlAggregate> pose;
    std::optional<JointMove> joints;  // empty: known only to the controller
    bool stays = false;               // $POS_ACT: no motion
  };

  Target target(TokenReader& reader);
  Target named_target(TokenReader& reader);
  void read_behind(TokenReader& reader, bool& flies);
  void add_pose_move(MotionKind kind, const std::optional<KrlAggregate>& via,
                     const KrlAggregate& pose, bool flies, const Place& place);
  void add_axes_move(const JointMove& move, const Place& place);
  void add_waiting_outputs();
  std::size_t pose_text(const KrlAggregate& literal, std::size_t frames, const Place& place);
  std::size_t frames_index();

  ProgramText& text_;
  const KrlVariables& variables_;
  KrlSetter& setter_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> poses_;  // by file and offset
  std::map<std::string, std::size_t> frames_;
  std::vector<std::pair<SetOutput, Place>> waiting_;
  std::optional<std::size_t> last_pose_;  // where the last motion ended; none: no pose known
  std::size_t last_frames_ = 0;
  bool triggered_ = false;  // the next motion triggers something
  std::optional<bool>
      turns_otherwise_;  // the program sets how the tool turns on arcs; none: unknown
};

}  // namespace tool_path_programs
