// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pdl2/pdl2_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pdl2/pdl2_files.h"
#include "pdl2_reader/pdl2_conventions.h"
#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/blocks.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kMostLines = 5000;    // from a public post processor
constexpr double kFastest = 3;              // [m/s]
constexpr std::size_t kCommentWidth = 120;  // longer ones are wrapped
constexpr int kSpeedDigits = 7;             // $LIN_SPD [m/s]
constexpr int kZoneDigits = 4;              // $FLY_DIST [mm]

void check_dialect(const std::string& dialect) {
  if (!dialect.empty() && dialect != "c5g" && dialect != "c4g")
    throw scan_cell_common::InvalidParameter("dialect", dialect, "give c5g or c4g");
}

std::string pos(const Eigen::Isometry3d& pose) {
  const Pdl2Numbers numbers = pdl2_numbers(pose);
  std::string text = "POS(";
  for (std::size_t field = 0; field < numbers.size(); ++field)
    text.append(fixed(numbers[field], pdl2_digits(field))).append(", ");
  return text + "'')";
}

class Writer {
 public:
  Writer(const Program& program, const WriteSettings& settings)
      : program_(program), settings_(settings) {}

  WrittenProgram run() {
    check(program_);
    check_dialect(settings_.dialect);
    check_pdl2_name("program name", program_.name);
    routine_.name = program_.name;
    add_head();
    for (const Step& step : program_.steps)
      std::visit([&](const auto& what) { add(what); }, step);
    return {pdl2_files(routine_, settings_.max_lines > 0 ? settings_.max_lines : kMostLines),
            notes()};
  }

 private:
  void add_head() {
    for (const std::string& comment : program_.comments)
      for (const std::string& line : comment_lines(comment, kCommentWidth))
        routine_.comments.push_back("-- " + line);
    routine_.head = {"$ORNT_TYPE := RS_WORLD", "$MOVE_TYPE := JOINT", "$CNFG_CARE := FALSE",
                     "$TURN_CARE := FALSE",    "$TERM_TYPE := FINE",  "$FLY_TYPE := FLY_CART",
                     "$FLY_TRAJ := FLY_FROM",  "$SPD_OPT := SPD_LIN"};
  }

  void add(const Move& move) {
    ++waypoint_;
    check_way(move);
    if (move.frames != frames_) set_frames(move);
    if (move.kind == MotionKind::kJoint) {
      block_.push_back("MOVE JOINT TO " + pos(move.pose) +
                       " WITH $PROG_SPD_OVR = " + percent(move.joint_speed));
    } else {
      set_speed(move);
      set_zone(move);
      const bool circular = move.kind == MotionKind::kCircular;
      block_.push_back((move.zone > 0 ? "MOVEFLY " : "MOVE ") +
                       std::string(circular ? "CIRCULAR TO " : "LINEAR TO ") + pos(move.pose) +
                       (circular ? " VIA " + pos(*move.via) : "") +
                       (move.zone > 0 ? " ADVANCE" : ""));
    }
    end_block();
    last_ = &move;
  }

  void add(const JointMove& move) {
    if (move.joints.empty() || move.joints.size() > 10)
      refuse(fmt::format("{} angles of the axes", move.joints.size()), "give 1 to 10");
    std::string axes;
    for (const double angle : move.joints)
      axes += (axes.empty() ? "" : ", ") + exact(angle);
    block_.push_back("MOVE TO {" + axes + "}");
    end_block();
    last_ = nullptr;
  }

  void add(const SetOutput& output) {
    const auto number = scan_cell_common::parse_count(output.output);
    if (!number || *number == 0)
      throw UnusableInput("output", scan_cell_common::excerpt(output.output),
                          "PDL2 knows outputs by number: give one from 1 up");
    if (last_ && last_->zone > 0)
      refuse("an output that switches where the tool flies by",
             "let the tool stop there, zone 0: it would switch early");
    block_.push_back(fmt::format("$DOUT[{}] := {}", *number, output.on ? "ON" : "OFF"));
    end_block();
  }

  void end_block() {
    routine_.blocks.push_back(std::move(block_));
    block_.clear();
  }

  void set_frames(const Move& move) {
    frames_ = move.frames;
    set_frame("$TOOL", program_.frames[move.frames].tool);
    set_frame("$UFRAME", program_.frames[move.frames].user);
  }

  void set_frame(const std::string& variable, const Frame& frame) {
    if (frame.pose)
      block_.push_back(variable + " := " + pos(*frame.pose));
    else if (!frame.name.empty())
      block_.push_back(variable + " := " + declared(frame.name));
    else
      open_frames_ = true;
  }

  /// tools.gun: the variable gun of the program tools.
  std::string declared(const std::string& name) {
    const std::size_t point = name.find('.');
    if (point == std::string::npos)
      throw UnusableInput("frame", scan_cell_common::excerpt(name),
                          "name the program that holds it: program.variable");
    const std::string variable = name.substr(point + 1);
    check_pdl2_name("program of a frame", name.substr(0, point));
    check_pdl2_name("frame", variable);
    const std::string line = variable + " : POSITION EXPORTED FROM " + name.substr(0, point);
    auto& lines = routine_.variables;
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(line);
    return variable;
  }

  void set_speed(const Move& move) {
    if (move.speed > kFastest)
      refuse(fmt::format("{:g} m/s", move.speed), "give up to 3 m/s along lines");
    const std::string text = shortest(move.speed, kSpeedDigits);
    check_rounding(move.speed, text, 1, 1e-7, "m/s");
    set(speed_, "$LIN_SPD := ", text);
  }

  std::string percent(double share) const {
    const std::string text = fixed(100 * share, 0);
    check_rounding(share, text, 0.01, 0.01, "of the axes' speed; PDL2 takes whole percents");
    return text;
  }

  void check_rounding(double wanted, const std::string& text, double unit, double least,
                      const std::string& what) const {
    const double said = scan_cell_common::parse_number(text).value_or(0) * unit;
    if (said > 0 && std::abs(said - wanted) <= settings_.max_speed_change * wanted) return;
    refuse(fmt::format("{:g} {}", wanted, what),
           fmt::format("the language can express {:g}: give that, or a greater max_speed_change",
                       std::max(said, least)));
  }

  void set_zone(const Move& move) {
    if (!(move.zone > 0)) return;
    const std::string text = shortest(1000 * move.zone, kZoneDigits);
    if (text == "0") refuse(fmt::format("zone {:g} m", move.zone), "give 1e-7 m, or 0 for a stop");
    set(zone_, "$FLY_DIST := ", text);
  }

  void set(std::string& now, const std::string& statement, const std::string& value) {
    if (now == value) return;
    now = value;
    block_.push_back(statement + value);
  }

  void check_way(const Move& move) const {
    if (move.kind == MotionKind::kJoint) {
      if (move.zone > 0)
        refuse("a joint move with a zone",
               "PDL2 gives it in percent: let the tool stop there, zone 0");
      return;
    }
    if (!last_ && move.kind == MotionKind::kCircular)
      refuse("an arc that begins at angles of the axes", "a move to a pose must come before it");
    if (!last_ || last_->frames != move.frames) return;
    const double turn = turn_between(*last_, move);
    if (turn >= kOpenTurn)
      refuse(fmt::format("the tool turns by {:.4g} degrees in one step", turn * 180 / M_PI),
             "the direction of the turn is ambiguous: put a waypoint between");
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes = {
        "configurations and turns are not given ($CNFG_CARE, $TURN_CARE := FALSE): start near the "
        "first pose, with the arm in the intended configuration"};
    if (open_frames_) notes.emplace_back("tool or user frame is what the controller has");
    return notes;
  }

  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const {
    throw UnusableInput(fmt::format("program {}, waypoint {}", program_.name, waypoint_), value,
                        cure);
  }

  const Program& program_;
  const WriteSettings& settings_;
  Pdl2Routine routine_;
  Block block_;
  std::size_t waypoint_ = 0;
  std::size_t frames_ = std::size_t(-1);
  const Move* last_ = nullptr;
  std::string speed_, zone_;
  bool open_frames_ = false;
};

}  // namespace

WrittenProgram write_pdl2(const Program& program, const WriteSettings& settings) {
  return Writer(program, settings).run();
}

}  // namespace tool_path_programs
