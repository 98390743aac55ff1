// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl/krl_writer.h"

#include <fmt/format.h>

#include <cmath>

#include "krl/krl_files.h"
#include "krl/krl_limits.h"
#include "krl_values/krl_conventions.h"
#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/blocks.h"
#include "text/number_text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kFastest = 3;              // [m/s] of $VEL.CP
constexpr std::size_t kCommentWidth = 120;  // longer ones are wrapped
constexpr int kSpeedDigits = 7;             // $VEL.CP [m/s]: 0.0001 mm/s
constexpr int kZoneDigits = 4;              // $APO.CDIS [mm]

class Writer {
 public:
  Writer(const Program& program, const WriteSettings& settings)
      : program_(program), settings_(settings) {}

  WrittenProgram run() {
    check(program_);
    check_krl_name(program_.name);
    const std::size_t lines =
        settings_.max_lines > 0 ? settings_.max_lines : krl_lines_of(settings_.dialect);
    routine_.name = program_.name;
    add_head();
    for (const Step& step : program_.steps)
      std::visit([&](const auto& what) { add(what); }, step);
    if (!block_.empty()) end_block();
    WrittenProgram written{krl_files(routine_, lines), notes()};
    return written;
  }

 private:
  void add_head() {
    for (const std::string& comment : program_.comments)
      for (const std::string& line : comment_lines(comment, kCommentWidth))
        routine_.head.push_back("; " + line);
    for (const char* line :
         {";FOLD INI", "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )",
          "INTERRUPT ON 3", "BAS (#INITMOV,0 )", ";ENDFOLD (INI)", "PTP $AXIS_ACT"})
      routine_.head.emplace_back(line);
  }

  void add(const Move& move) {
    ++waypoint_;
    check_turn(move);
    if (move.frames != frames_) set_frames(move);
    if (move.kind == MotionKind::kJoint) set_joint_speed(move);
    if (move.kind != MotionKind::kJoint) set_speed(move);
    set_zone(move);
    const std::string zone = move.zone > 0 ? " C_DIS" : "";
    if (move.kind == MotionKind::kJoint) block_.push_back("PTP " + literal(move.pose));
    if (move.kind == MotionKind::kLinear) block_.push_back("LIN " + literal(move.pose) + zone);
    if (move.kind == MotionKind::kCircular && !last_)
      refuse("an arc that begins at angles of the axes", "a move to a pose must come before it");
    if (move.kind == MotionKind::kCircular)
      block_.push_back("CIRC " + literal(*move.via) + "," + literal(move.pose) + zone);
    end_block();
    last_ = &move;
  }

  void add(const JointMove& move) {
    std::string axes;
    if (move.joints.empty() || move.joints.size() > 12)
      refuse(fmt::format("{} angles of the axes", move.joints.size()), "give 1 to 12");
    for (std::size_t i = 0; i < move.joints.size(); ++i)
      axes += fmt::format("{}{}{} {}", i == 0 ? "" : ",", i < 6 ? "A" : "E", i % 6 + 1,
                          exact(move.joints[i]));
    block_.push_back("PTP {" + axes + "}");
    end_block();
    last_ = nullptr;
  }

  /// After a fly-by, the controller switches where the next motion begins, in the middle of the
  /// zone; after a stop, when the tool is at the pose.
  void add(const SetOutput& output) {
    const std::string statement =
        fmt::format("$OUT[{}]={}", krl_output_number(output.output), output.on ? "TRUE" : "FALSE");
    if (last_ && last_->zone > 0 && a_motion_follows(output)) {
      block_.push_back("TRIGGER WHEN DISTANCE=0 DELAY=0 DO " + statement);
      return;
    }
    block_.push_back(statement);
    end_block();
  }

  bool a_motion_follows(const SetOutput& output) const {
    const Step* step = &program_.steps.back();
    while (std::get_if<SetOutput>(step) && std::get_if<SetOutput>(step) != &output)
      --step;
    return std::get_if<SetOutput>(step) != &output;
  }

  void end_block() {
    routine_.blocks.push_back(std::move(block_));
    block_.clear();
  }

  void set_frames(const Move& move) {
    frames_ = move.frames;
    const Frames& frames = program_.frames[move.frames];
    set_frame(frames.tool, "TOOL");
    set_frame(frames.user, "BASE");
  }

  void set_frame(const Frame& frame, const std::string& kind) {
    if (frame.pose) {
      block_.push_back(fmt::format("${}={}", kind, literal(*frame.pose)));
      if (kind == "TOOL") given_tool_ = true;
    } else if (!frame.name.empty()) {
      block_.push_back(
          fmt::format("BAS (#{},{} )", kind, krl_frame_number(frame.name, kind + "_DATA")));
    } else {
      open_frames_ = true;
    }
  }

  void set_speed(const Move& move) {
    if (move.speed > kFastest)
      refuse(fmt::format("{:g} m/s", move.speed), "KUKA's robots take up to 3 m/s along lines");
    const std::string text = shortest(move.speed, kSpeedDigits);
    check_rounding(move.speed, text, 1, "m/s");
    set(speed_, "$VEL.CP=", text);
  }

  void set_joint_speed(const Move& move) {
    const std::string text = fixed(100 * move.joint_speed, 0);
    check_rounding(move.joint_speed, text, 0.01, "of the axes' speed; KRL takes whole percents");
    set(joint_speed_, "BAS (#VEL_PTP,", text + " )");
  }

  void check_rounding(double wanted, const std::string& text, double unit,
                      const std::string& what) const {
    const double said = scan_cell_common::parse_number(text).value_or(0) * unit;
    if (said > 0 && std::abs(said - wanted) <= settings_.max_speed_change * wanted) return;
    refuse(fmt::format("{:g} {}", wanted, what),
           fmt::format("the language can express {:g}: give that, or a greater max_speed_change",
                       std::max(said, text.find('.') == std::string::npos ? unit : 1e-7)));
  }

  void set_zone(const Move& move) {
    if (!(move.zone > 0)) return;
    if (move.kind == MotionKind::kJoint)
      refuse("a joint move with a zone",
             "KRL gives it in percent: let the tool stop there, zone 0");
    const std::string text = shortest(1000 * move.zone, kZoneDigits);
    if (text == "0") refuse(fmt::format("zone {:g} m", move.zone), "give 1e-7 m, or 0 for a stop");
    set(zone_, "$APO.CDIS=", text);
  }

  void set(std::string& now, const std::string& statement, const std::string& value) {
    if (now == value) return;
    now = value;
    block_.push_back(statement + value);
  }

  void check_turn(const Move& move) const {
    if (!last_ || move.kind == MotionKind::kJoint || last_->frames != move.frames) return;
    const double turn = turn_between(*last_, move);
    if (turn >= kOpenTurn)
      refuse(fmt::format("the tool turns by {:.4g} degrees in one step", turn * 180 / M_PI),
             "the direction of the turn is ambiguous: put a waypoint between");
  }

  static std::string literal(const Eigen::Isometry3d& pose) {
    const KrlNumbers numbers = krl_numbers(pose);
    std::string text;
    for (std::size_t field = 0; field < numbers.size(); ++field)
      text.append(field == 0 ? "{" : ",")
          .append(kKrlFields[field])
          .append(" ")
          .append(fixed(numbers[field], krl_digits(field)));
    return text + "}";
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes = {
        "the first motion goes to where the robot stands (PTP $AXIS_ACT); S and T are not given: "
        "start near the first pose, with the arm in the intended configuration"};
    if (open_frames_) notes.emplace_back("tool or base is what the controller has at the start");
    if (given_tool_) notes.emplace_back("the tool's load is what the controller has: set $LOAD");
    return notes;
  }

  [[noreturn]] void refuse(const std::string& value, const std::string& cure) const {
    throw UnusableInput(fmt::format("program {}, waypoint {}", program_.name, waypoint_), value,
                        cure);
  }

  const Program& program_;
  const WriteSettings& settings_;
  KrlRoutine routine_;
  Block block_;
  std::size_t waypoint_ = 0;
  std::size_t frames_ = std::size_t(-1);
  const Move* last_ = nullptr;
  std::string speed_, joint_speed_, zone_;
  bool open_frames_ = false;
  bool given_tool_ = false;
};

}  // namespace

WrittenProgram write_krl(const Program& program, const WriteSettings& settings) {
  return Writer(program, settings).run();
}

}  // namespace tool_path_programs
