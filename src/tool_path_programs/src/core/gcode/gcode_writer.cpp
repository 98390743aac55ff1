// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode/gcode_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <utility>

#include "gcode/gcode_limits.h"
#include "gcode_reader/gcode_axes.h"
#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

constexpr int kMillimetreDigits = 4;
constexpr int kDegreeDigits = 5;
constexpr double kPerMinute = 60e3;  // 1 m/s in mm/min

class Writer {
 public:
  Writer(const Program& program, const GcodeDialect& dialect)
      : program_(program), dialect_(dialect), at_(GcodeAxes::Constant(NAN)) {}

  WrittenProgram run() {
    text_ = comment(program_.name);
    for (const std::string& line : program_.comments)
      text_ += comment(line);
    text_ += "G21 G17 G90 G94 G40\n";  // mm, arcs in XY, absolute, feed per minute
    for (const Step& step : program_.steps)
      add(step);
    note_machine();
    WrittenProgram written;
    written.files = {{program_.name + ".ngc", text_ + "M2\n"}};
    written.notes = notes_;
    return written;
  }

 private:
  void add(const Step& step) {
    if (const Move* move = std::get_if<Move>(&step)) return add(*move);
    const SetOutput& output = std::get<SetOutput>(step);
    if (output.output == "spindle")
      text_ += output.on ? "M3\n" : "M5\n";
    else if (output.output == "mist" || output.output == "flood")
      add_coolant(output);
    else
      text_ += (output.on ? "M64 P" : "M65 P") + output.output + "\n";
  }

  /// M9 switches both off.
  void add_coolant(const SetOutput& output) {
    if (!output.on)
      throw scan_cell_common::UnusableInput("output " + output.output,
                                            "M9 switches mist and flood off together",
                                            "give a digital output: 0 to 63");
    text_ += output.output == "mist" ? "M7\n" : "M8\n";
  }

  void add(const Move& move) {
    ++waypoint_;
    choose(program_.frames[move.frames]);
    const std::string mode =
        move.zone > 0 ? "G64 P" + shortest(1e3 * move.zone, kGcodeToleranceDigits) : "G61.1";
    if (std::exchange(mode_, mode) != mode) text_ += mode + "\n";
    text_ += move.kind == MotionKind::kJoint ? "G0" : "G1";
    add_axes(move);
    if (move.kind == MotionKind::kLinear) {
      const std::string feed = " F" + shortest(kPerMinute * move.speed, kGcodeFeedDigits);
      if (std::exchange(feed_, feed) != feed) text_ += feed;
    }
    text_ += "\n";
  }

  void add_axes(const Move& move) {
    const GcodeAxes axes = dialect_.axes(move.pose, at_);
    for (const Eigen::Index axis : dialect_.axes()) {
      const double way = std::abs(axes[axis] - at_[axis]);
      const char letter = "XYZABC"[axis];
      if (axis > 2 && move.kind != MotionKind::kJoint && way >= kOpenTurn * 180 / M_PI)
        throw scan_cell_common::UnusableInput(
            fmt::format("program {}, waypoint {}", program_.name, waypoint_),
            fmt::format("axis {} turns by {:.1f} degrees in one step", letter, way),
            "the tool passes a direction where the axes flip: turn the part on the table, or "
            "put waypoints between");
      text_ += fmt::format(" {}{}", letter,
                           fixed(axes[axis], axis > 2 ? kDegreeDigits : kMillimetreDigits));
    }
    at_ = axes;
  }

  void choose(const Frames& frames) {
    if (!frames.user.name.empty() && std::exchange(user_, frames.user.name) != frames.user.name)
      text_ += frames.user.name + "\n";
    if (!frames.tool.name.empty() && std::exchange(tool_, frames.tool.name) != frames.tool.name)
      text_ += fmt::format("T{} M6\nG43 H{}\n", frames.tool.name, frames.tool.name);
    note(frames.user.name.empty()
             ? "the coordinate system is the one that is active on the machine"
             : frames.user.name + " must be set on the machine to the user frame");
    note(frames.tool.name.empty()
             ? "the tool is the one that is active on the machine"
             : "tool " + frames.tool.name + " must have its length in the machine's tool table");
  }

  void note_machine() {
    if (dialect_.name() == "xyz")
      note("the tool's direction is the machine's own: the program does not say it");
    else
      note(
          "positions are those of the tool's tip: the machine must keep the tip where the rotary "
          "axes turn (tool centre point control)");
    note("G0 runs at the machine's own speed");
  }

  void note(const std::string& line) {
    if (known_notes_.insert(line).second) notes_.push_back(line);
  }

  /// Removes brackets, which would end the comment.
  static std::string comment(std::string line) {
    for (char& character : line)
      if (character == '\n' || character == '\r') character = ' ';
    return "; " + line + "\n";
  }

  const Program& program_;
  const GcodeDialect& dialect_;
  GcodeAxes at_;
  std::string text_;
  std::string mode_;
  std::string feed_;
  std::string user_;
  std::string tool_;
  std::size_t waypoint_ = 0;
  std::vector<std::string> notes_;
  std::set<std::string> known_notes_;
};

}  // namespace

WrittenProgram write_gcode(const Program& program, const WriteSettings& settings) {
  const GcodeDialect dialect(settings.dialect);
  if (settings.max_lines != 0)
    throw scan_cell_common::InvalidParameter(
        "max_lines", std::to_string(settings.max_lines),
        "leave it out: machines read G-code line by line, and nothing is split");
  check_for_gcode(program, settings, dialect);
  return Writer(program, dialect).run();
}

}  // namespace tool_path_programs
