// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc/fanuc_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fanuc/fanuc_words.h"
#include "fanuc_reader/fanuc_angles.h"
#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

constexpr std::size_t kMostLines = 9999;  // in one program, from public post processors
constexpr std::size_t kFewestLines = 30;
constexpr std::size_t kLongestName = 36;
constexpr std::size_t kLongestRemark = 32;
constexpr std::size_t kMostLinesOfFrames = 2;
constexpr int kMostFrames = 61;
constexpr int kMostTools = 29;

/// Statements of a program, and its positions.
struct Part {
  std::vector<std::string> lines;
  std::string positions;
  std::size_t position_count = 0;
};

class Writing {
 public:
  Writing(const Program& program, const WriteSettings& settings)
      : program_(program),
        settings_(settings),
        corner_regions_(fanuc_has_corner_regions(settings)),
        max_lines_(settings.max_lines == 0 ? kMostLines : settings.max_lines) {}

  WrittenProgram run() {
    if (max_lines_ < kFewestLines)
      throw InvalidParameter("max_lines", std::to_string(max_lines_), "give 30 or more, or 0");
    check_fanuc_name(program_.name, kLongestName - std::string("_9999").size());
    add_head();
    parts_.emplace_back();
    for (std::size_t i = 0; i < program_.steps.size(); ++i)
      add_step(i);
    join();
    add_notes();
    return std::move(written_);
  }

 private:
  void add_head() {
    for (const std::string& comment : program_.comments)
      add_remark(comment);
    for (const Frames& frames : program_.frames) {
      const int tool = fanuc_frame_number(frames.tool, "tool", kMostTools);
      const int user = fanuc_frame_number(frames.user, "user frame", kMostFrames);
      numbers_.emplace_back(user, tool);
      describe(frames.tool, fmt::format("UTOOL {}", tool));
      describe(frames.user, fmt::format("UFRAME {}", user));
    }
  }

  void describe(const Frame& frame, const std::string& name) {
    if (!frame.pose || !described_.insert(name).second) return;
    static const std::array<const char*, 6> axes = {"X", "Y", "Z", "W", "P", "R"};
    const FanucPose numbers = fanuc_pose(*frame.pose, {3, 3, 3});
    std::string all;
    for (std::size_t i = 0; i < axes.size(); i += 2) {
      const std::string line = fmt::format("{} {} {} {}", axes[i], fixed(numbers[i], 3),
                                           axes[i + 1], fixed(numbers[i + 1], 3));
      add_remark(name + ": " + line);
      all += " " + line;
    }
    frame_notes_.push_back(name + " must be set on the controller to" + all);
  }

  /// The controller takes 32 ASCII characters a line.
  void add_remark(const std::string& comment) {
    std::string text;
    for (const char character : comment) {
      const bool plain = character >= ' ' && character <= '~' && character != ';';
      replaced_ = replaced_ || !plain;
      text += plain ? character : '?';
    }
    for (std::size_t first = 0; first == 0 || first < text.size(); first += kLongestRemark)
      head_.push_back("  !" + text.substr(first, kLongestRemark));
  }

  void add_step(std::size_t i) {
    if (const Move* move = std::get_if<Move>(&program_.steps[i])) return add_move(*move);
    if (const SetOutput* output = std::get_if<SetOutput>(&program_.steps[i]))
      return add_output(*output);
    add_joint_move(std::get<JointMove>(program_.steps[i]));
  }

  /// A part with room for some lines, with these frames selected.
  Part& part_with(std::size_t lines, const std::pair<int, int>& frames) {
    if (parts_.back().lines.size() + lines + kMostLinesOfFrames > max_lines_) {
      parts_.emplace_back();
      selected_.reset();
    }
    Part& part = parts_.back();
    if (selected_ != frames) {
      part.lines.push_back(fmt::format("  UFRAME_NUM={} ", frames.first));
      part.lines.push_back(fmt::format("  UTOOL_NUM={} ", frames.second));
    }
    selected_ = frames;
    return part;
  }

  void add_move(const Move& move) {
    ++waypoint_;
    check_way(move);
    const std::pair<int, int> frames = numbers_[move.frames];
    Part& part = part_with(1, frames);
    const bool joint = move.kind == MotionKind::kJoint;
    if (joint && corner_regions_ && move.zone > 0)
      throw UnusableInput(name_of_waypoint(), "a joint move with a zone",
                          "corner regions are for lines and arcs: give zone 0");
    std::string line = joint ? "J " : move.kind == MotionKind::kLinear ? "L " : "C ";
    if (move.via) {
      line += fmt::format("P[{}] \r\n    :  ", ++part.position_count);
      part.positions +=
          fanuc_position(part.position_count, *move.via, move.joints, frames.first, frames.second);
    }
    line += fmt::format("P[{}] ", ++part.position_count);
    part.positions +=
        fanuc_position(part.position_count, move.pose, move.joints, frames.first, frames.second);
    line += joint ? fanuc_share(move.joint_speed, settings_.max_speed_change, waypoint_)
                  : fanuc_speed(move.speed, settings_.max_speed_change, waypoint_);
    part.lines.push_back(line + " " + fanuc_zone(move.zone, corner_regions_, waypoint_) + "    ");
    without_joints_ = without_joints_ || !move.joints;
    shares_ = shares_ || (move.zone > 0 && !corner_regions_);
    last_ = &move;
  }

  std::string name_of_waypoint() const { return "FANUC TP, waypoint " + std::to_string(waypoint_); }

  void check_way(const Move& move) const {
    if (move.kind == MotionKind::kJoint) return;
    if (move.kind == MotionKind::kCircular && !last_)
      throw UnusableInput(name_of_waypoint(), "an arc without a pose before it",
                          "begin with a line");
    if (!last_ || last_->frames != move.frames) return;
    const double turn = turn_between(*last_, move);
    if (turn >= kOpenTurn)
      throw UnusableInput(name_of_waypoint(),
                          fmt::format("turned by {:.4g} degrees from the one before, which leaves "
                                      "the direction of the turn ambiguous",
                                      turn * 180 / M_PI),
                          "put a waypoint between them");
  }

  void add_output(const SetOutput& output) {
    const std::string& name = output.output;
    const bool robot_output = name.size() > 4 && name.compare(0, 3, "RO[") == 0;
    const std::string number = robot_output ? name.substr(3, name.size() - 4) : name;
    const auto index = scan_cell_common::parse_count(number);
    if (!index || *index == 0 || *index > 99999 || std::to_string(*index) != number ||
        (robot_output && name.back() != ']'))
      throw UnusableInput("output '" + scan_cell_common::excerpt(name) + "'", "not a FANUC output",
                          "give the number of a digital output, such as 5, or RO[5]");
    if (last_ && last_->zone > 0)
      throw UnusableInput(name_of_waypoint(), "an output that changes on the way",
                          "it would switch early: let the tool stop there, zone 0");
    Part& part = room_for_output();
    part.lines.push_back(
        fmt::format("  {}[{}]={} ", robot_output ? "RO" : "DO", number, output.on ? "ON" : "OFF"));
  }

  Part& room_for_output() {
    if (selected_) return part_with(1, *selected_);
    if (parts_.back().lines.size() + 1 > max_lines_) parts_.emplace_back();
    return parts_.back();
  }

  void add_joint_move(const JointMove& move) {
    if (move.joints.size() != 6)
      throw UnusableInput("FANUC TP, joint move", fmt::format("{} angles", move.joints.size()),
                          "give 6");
    const std::pair<int, int> frames = selected_.value_or(numbers_.front());
    Part& part = part_with(1, frames);
    part.positions +=
        fanuc_joint_position(++part.position_count, move.joints, frames.first, frames.second);
    part.lines.push_back(fmt::format("J P[{}] 10% FINE    ", part.position_count));
    last_ = nullptr;
  }

  void join() {
    if (parts_.size() == 1 && head_.size() + parts_.front().lines.size() <= max_lines_) {
      Part all = std::move(parts_.front());
      all.lines.insert(all.lines.begin(), head_.begin(), head_.end());
      written_.files = {file(program_.name, all)};
      return;
    }
    Part main;
    main.lines = head_;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const std::string name = fmt::format("{}_{}", program_.name, i + 1);
      main.lines.push_back(fmt::format("  CALL {} ", name));
      written_.files.push_back(file(name, parts_[i]));
    }
    if (main.lines.size() > max_lines_ || parts_.size() > 9999)
      throw InvalidParameter(
          "max_lines", std::to_string(max_lines_),
          fmt::format("its main program alone has {} lines: give more", main.lines.size()));
    written_.files.insert(written_.files.begin(), file(program_.name, main));
  }

  static SourceFile file(const std::string& name, const Part& part) {
    std::string text = fmt::format(
        "/PROG  {}\r\n/ATTR\r\nOWNER\t\t= MNEDITOR;\r\nCOMMENT\t\t= \"\";\r\nPROG_SIZE\t= 0;\r\n"
        "FILE_NAME\t= ;\r\nVERSION\t\t= 0;\r\nLINE_COUNT\t= {};\r\nMEMORY_SIZE\t= 0;\r\n"
        "PROTECT\t\t= READ_WRITE;\r\nTCD:  STACK_SIZE\t= 0,\r\n      TASK_PRIORITY\t= 50,\r\n"
        "      TIME_SLICE\t= 0,\r\n      BUSY_LAMP_OFF\t= 0,\r\n      ABORT_REQUEST\t= 0,\r\n"
        "      PAUSE_REQUEST\t= 0;\r\nDEFAULT_GROUP\t= 1,*,*,*,*;\r\n"
        "CONTROL_CODE\t= 00000000 00000000;\r\n/MN\r\n",
        name, part.lines.size());
    for (std::size_t i = 0; i < part.lines.size(); ++i)
      text += fmt::format("{:>4}:{};\r\n", i + 1, part.lines[i]);
    return {name + ".ls", text + "/POS\r\n" + part.positions + "/END\r\n"};
  }

  void add_notes() {
    auto& notes = written_.notes;
    if (written_.files.size() > 1)
      notes.push_back(fmt::format("more than {} lines: {} programs; load all of them", max_lines_,
                                  written_.files.size()));
    if (shares_)
      notes.emplace_back(
          "zones are written as CNT100: how far from a pose the robot turns off "
          "depends on speed and acceleration; the dialect cr says it in mm");
    notes.emplace_back(without_joints_
                           ? "each position has the configuration N U T, 0, 0, 0: check that it is "
                             "the robot's where it works"
                           : "each position has the configuration N U T: check that it is the "
                             "robot's where it works; the turns are those of the joints");
    if (replaced_) notes.emplace_back("characters of comments that are not ASCII became ?");
    notes.insert(notes.end(), frame_notes_.begin(), frame_notes_.end());
  }

  const Program& program_;
  const WriteSettings& settings_;
  const bool corner_regions_;
  const std::size_t max_lines_;
  std::vector<std::pair<int, int>> numbers_;  // of each of the program's frames: user, tool
  std::vector<std::string> head_;
  std::vector<Part> parts_;
  std::optional<std::pair<int, int>> selected_;
  std::set<std::string> described_;
  std::vector<std::string> frame_notes_;
  WrittenProgram written_;
  std::size_t waypoint_ = 0;
  const Move* last_ = nullptr;
  bool shares_ = false;
  bool without_joints_ = false;
  bool replaced_ = false;
};

}  // namespace

bool fanuc_has_corner_regions(const WriteSettings& settings) {
  if (settings.dialect.empty() || settings.dialect == "cnt") return false;
  if (settings.dialect == "cr") return true;
  throw InvalidParameter("dialect", settings.dialect, "give cnt or cr");
}

WrittenProgram write_fanuc(const Program& program, const WriteSettings& settings) {
  check(program);
  return Writing(program, settings).run();
}

}  // namespace tool_path_programs
