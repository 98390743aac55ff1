// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gcode_reader/gcode_axes.h"
#include "gcode_reader/gcode_blocks.h"
#include "tool_path_programs/program.h"

namespace tool_path_programs {

const std::string kPoseLetters = "XYZABC";

/// Millimetres in an inch.
constexpr double kGcodeInch = 25.4;

/// What a block makes the machine do, in this order.
struct GcodeAction {
  std::vector<SetOutput> outputs;
  enum class Kind {
    kNone,
    kMove,        // to a pose
    kIncomplete,  // to some axes only while others are unknown, or to the machine's own places
  };
  Kind kind = Kind::kNone;
  int motion = 0;                      // 0 to 3, of G0 to G3
  GcodeAxes to = GcodeAxes::Zero();    // of kMove
  std::optional<Eigen::Vector3d> via;  // [mm] of an arc
  std::vector<double> values;          // of kIncomplete, as written
};

/// A machine that reads G-code, with its modal state: what stays until a word changes it.
class GcodeMachine {
 public:
  /// @param calls_without_motion M functions known not to move, such as M101
  GcodeMachine(const SourceFile& file, const GcodeDialect& dialect,
               const std::set<std::string>& calls_without_motion);

  /// @throw scan_cell_common::UnusableInput naming file and line of what cannot be resolved
  GcodeAction run(const GcodeBlock& block);

  bool has_ended() const { return ended_; }                 //!< M2, M30
  double unit() const { return inches_ ? kGcodeInch : 1; }  //!< of the words, in mm
  int digits(Eigen::Index axis) const;                      //!< decimals that its words need
  double feed() const { return feed_; }                     //!< [mm/min]; NaN: not given
  double tolerance() const { return tolerance_; }           //!< [mm] of G64 P; 0: none
  const std::string& user() const { return user_; }         //!< G54; empty: none chosen
  const std::string& tool() const { return tool_; }         //!< number; empty: none chosen

 private:
  void preparatory(const GcodeWord& word);
  void miscellaneous(const GcodeWord& word, GcodeAction& action);
  void set_frame(int code);
  void set_modes();
  void move(GcodeAction& action);
  void move_to_own_places(GcodeAction& action);
  void arc(GcodeAction& action, const GcodeAxes& from) const;
  bool has_axes() const;
  double coordinate(const GcodeWord& word) const;
  [[noreturn]] void fail(const std::string& value, const std::string& cure) const;

  const SourceFile& file_;
  const GcodeDialect& dialect_;
  const std::set<std::string>& calls_without_motion_;
  const GcodeBlock* block_ = nullptr;
  GcodeAxes at_;
  int motion_ = -1;          // none
  Eigen::Index normal_ = 2;  // of the plane of arcs
  bool inches_ = false;
  bool incremental_ = false;
  bool own_places_ = false;  // in this block: G28, G30, G53
  bool dwells_ = false;      // in this block
  double feed_;
  double tolerance_ = 0;
  std::string user_;
  std::string tool_;
  std::string next_tool_;
  bool ended_ = false;
};

/// Removes calls by M functions: they were found harmless when the program was read.
GcodeBlock gcode_without_calls(GcodeBlock block);

}  // namespace tool_path_programs
