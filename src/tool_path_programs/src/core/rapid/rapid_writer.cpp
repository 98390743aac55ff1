// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid/rapid_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/turn.h"
#include "rapid/rapid_frames.h"
#include "rapid/rapid_move_text.h"
#include "rapid/rapid_names.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

constexpr std::size_t kMostLines = 5000;  // in one module, from public post processors
constexpr std::size_t kFewestLines = 20;
constexpr std::size_t kLinesAround = 4;  // of a part: MODULE, PROC and their ends

class Writing {
 public:
  Writing(const Program& program, const WriteSettings& settings)
      : program_(program),
        settings_(settings),
        max_lines_(settings.max_lines == 0 ? kMostLines : settings.max_lines),
        frames_(program) {}

  WrittenProgram run() {
    check_settings();
    for (std::size_t i = 0; i < program_.steps.size(); ++i)
      add_step(i);
    join();
    add_notes();
    return std::move(written_);
  }

 private:
  void check_settings() const {
    if (max_lines_ < kFewestLines)
      throw InvalidParameter("max_lines", std::to_string(max_lines_), "give 20 or more, or 0");
    if (!settings_.dialect.empty() && settings_.dialect != "irc5")
      throw InvalidParameter("dialect", settings_.dialect, "RAPID has only irc5");
    check_rapid_name("program", program_.name, kLongestRapidName - std::string("mod__9999").size());
  }

  void add_step(std::size_t i) {
    if (const Move* move = std::get_if<Move>(&program_.steps[i])) return add_move(*move, i);
    if (const SetOutput* output = std::get_if<SetOutput>(&program_.steps[i]))
      return add_output(*output, i);
    add_joint_move(std::get<JointMove>(program_.steps[i]));
  }

  void add_move(const Move& move, std::size_t i) {
    ++waypoint_;
    check_way(move);
    const SetOutput* switched = move.zone > 0 ? output_after(i) : nullptr;
    std::string line = instruction(move.kind) + (switched ? "DO " : " ");
    if (move.via) line += rapid_robtarget(*move.via, std::nullopt) + ",";
    line += rapid_robtarget(move.pose, move.joints) + ",";
    const bool joint = move.kind == MotionKind::kJoint;
    line += rapid_speed(joint ? move.joint_speed * kRapidFullSpeed : move.speed,
                        settings_.max_speed_change, waypoint_);
    line += "," + rapid_zone(move.zone, waypoint_) + "," + frames_.arguments(move.frames);
    if (switched) line += fmt::format(",{},{}", switched->output, switched->on ? 1 : 0);
    body_.push_back(line + ";");
    joint_moves_ = joint_moves_ || joint;
    switches_on_the_way_ = switches_on_the_way_ || switched;
    last_ = &move;
  }

  static std::string instruction(MotionKind kind) {
    if (kind == MotionKind::kJoint) return "MoveJ";
    return kind == MotionKind::kLinear ? "MoveL" : "MoveC";
  }

  const SetOutput* output_after(std::size_t i) const {
    return i + 1 < program_.steps.size() ? std::get_if<SetOutput>(&program_.steps[i + 1]) : nullptr;
  }

  void check_way(const Move& move) const {
    const std::string thing = "RAPID, waypoint " + std::to_string(waypoint_);
    if (move.kind == MotionKind::kJoint) return;
    if (move.kind == MotionKind::kCircular && !last_)
      throw UnusableInput(thing, "an arc without a pose before it", "begin with a line");
    if (!last_ || last_->frames != move.frames) return;
    const double turn = turn_between(*last_, move);
    if (turn >= kOpenTurn)
      throw UnusableInput(thing,
                          fmt::format("turned by {:.4g} degrees from the one before, which leaves "
                                      "the direction of the turn ambiguous",
                                      turn * 180 / M_PI),
                          "put a waypoint between them");
  }

  /// After a stop the output is a statement of its own; on the way it is part of the move.
  void add_output(const SetOutput& output, std::size_t i) {
    check_rapid_name("output", output.output, kLongestRapidName);
    const Move* before = i == 0 ? nullptr : std::get_if<Move>(&program_.steps[i - 1]);
    if (before && before->zone > 0) return;
    if (last_ && last_->zone > 0)
      throw UnusableInput(
          "RAPID, waypoint " + std::to_string(waypoint_),
          "two outputs switch while the tool moves, but RAPID can switch only one there",
          "let the tool stop there: zone 0");
    body_.push_back(fmt::format("SetDO {},{};", output.output, output.on ? 1 : 0));
  }

  void add_joint_move(const JointMove& move) {
    if (move.joints.size() != 6)
      throw UnusableInput("RAPID, joint move", std::to_string(move.joints.size()) + " angles",
                          "give 6");
    // Joint angles need no tool: tool0 always exists.
    body_.push_back(fmt::format("MoveAbsJ [[{}],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;",
                                fmt::join(move.joints, ",")));
    last_ = nullptr;
  }

  void join() {
    std::vector<std::string> inside = {"ConfJ\\Off;", "ConfL\\Off;"};
    std::vector<std::string> head = comments();
    const auto declarations = frames_.declarations();
    head.insert(head.end(), declarations.begin(), declarations.end());
    if (head.size() + inside.size() + 2 + body_.size() + kLinesAround <= max_lines_)
      inside.insert(inside.end(), body_.begin(), body_.end());
    else
      split(inside, head);
    inside.insert(inside.end(), {"ConfL\\On;", "ConfJ\\On;"});
    written_.files.insert(written_.files.begin(), module(program_.name, head, inside));
  }

  void split(std::vector<std::string>& calls, const std::vector<std::string>& head) {
    const std::size_t size = max_lines_ - kLinesAround;
    for (std::size_t first = 0; first < body_.size(); first += size) {
      const std::string name = fmt::format("{}_{}", program_.name, first / size + 1);
      const auto begin = body_.begin() + static_cast<std::ptrdiff_t>(first);
      const auto end =
          body_.begin() + static_cast<std::ptrdiff_t>(std::min(body_.size(), first + size));
      written_.files.push_back(module(name, {}, {begin, end}));
      calls.push_back(name + ";");
    }
    if (written_.files.size() > 9999 || head.size() + calls.size() + 2 + kLinesAround > max_lines_)
      throw InvalidParameter("max_lines", std::to_string(max_lines_),
                             fmt::format("its main module alone has {} lines: give more",
                                         head.size() + calls.size() + 2 + kLinesAround));
  }

  std::vector<std::string> comments() const {
    std::vector<std::string> lines;
    for (const std::string& comment : program_.comments) {
      lines.emplace_back("! ");
      for (const char character : comment) {
        if (character == '\n') lines.emplace_back("! ");
        if (character != '\n' && character != '\r') lines.back() += character;
      }
    }
    return lines;
  }

  static SourceFile module(const std::string& name, const std::vector<std::string>& head,
                           const std::vector<std::string>& inside) {
    std::string text = "MODULE mod_" + name + "\r\n";
    for (const std::string& line : head)
      text += "  " + line + "\r\n";
    text += "  PROC " + name + "()\r\n";
    for (const std::string& line : inside)
      text += "    " + line + "\r\n";
    text += "  ENDPROC\r\nENDMODULE\r\n";
    return {name + ".mod", text};
  }

  void add_notes() {
    auto& notes = written_.notes;
    if (written_.files.size() > 1)
      notes.push_back(fmt::format("more than {} lines: {} modules; load all of them", max_lines_,
                                  written_.files.size()));
    if (joint_moves_)
      notes.emplace_back(
          "joint moves: 100 % of the axes' speed is written as 5000 mm/s of the tip");
    if (switches_on_the_way_)
      notes.emplace_back("outputs that change on the way do so in the middle of the zone");
    notes.emplace_back(
        "the arm's configuration is not supervised (ConfJ, ConfL off): start near "
        "the first pose, with the arm in the intended configuration");
    const auto of_frames = frames_.notes();
    notes.insert(notes.end(), of_frames.begin(), of_frames.end());
  }

  const Program& program_;
  const WriteSettings& settings_;
  const std::size_t max_lines_;
  const RapidFrames frames_;
  std::vector<std::string> body_;
  WrittenProgram written_;
  std::size_t waypoint_ = 0;
  const Move* last_ = nullptr;
  bool joint_moves_ = false;
  bool switches_on_the_way_ = false;
};

}  // namespace

WrittenProgram write_rapid(const Program& program, const WriteSettings& settings) {
  check(program);
  return Writing(program, settings).run();
}

}  // namespace tool_path_programs
