// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode/gcode_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "gcode_reader/gcode_axes.h"
#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr double kSameTurn = 0.001 * M_PI / 180;
constexpr double kFeedStep = 1e-6 / 60;      // [m/s] 0.001 mm/min
constexpr double kSmallestTolerance = 1e-6;  // [m]
constexpr int kMostOutputs = 64;             // from LinuxCNC

bool is_number(const std::string& text, int below) {
  return !text.empty() && text.size() < 6 &&
         text.find_first_not_of("0123456789") == std::string::npos &&
         (text.size() == 1 || text[0] != '0') && std::atoi(text.c_str()) < below;
}

class Limits {
 public:
  Limits(const Program& program, const WriteSettings& settings, const GcodeDialect& dialect)
      : program_(program), settings_(settings), dialect_(dialect) {}

  void check() {
    check_comments();
    for (const Frames& frames : program_.frames)
      check(frames);
    for (const Step& step : program_.steps) {
      if (const Move* move = std::get_if<Move>(&step))
        check(*move);
      else if (const SetOutput* output = std::get_if<SetOutput>(&step))
        check(*output);
      else
        fail("a move to angles of the axes", "give the pose that it leads to");
    }
    if (before_->zone > 0) fail("the last waypoint has a zone", "give it a zone of 0");
  }

 private:
  void check_comments() const {
    constexpr std::size_t kLongestLine = 200;  // LinuxCNC takes 255 characters
    if (program_.name.size() > kLongestLine)
      throw UnusableInput("program " + program_.name.substr(0, 20) + "...",
                          std::to_string(program_.name.size()) + " characters",
                          "give a name of at most 200");
  }

  static void check(const Frames& frames) {
    static const std::set<std::string> systems = {"G54", "G55",   "G56",   "G57",  "G58",
                                                  "G59", "G59.1", "G59.2", "G59.3"};
    const Frame& user = frames.user;
    if (!user.name.empty() && systems.count(user.name) == 0)
      throw UnusableInput("user frame " + user.name, "not a G-code coordinate system",
                          "name it G54 to G59, or G59.1 to G59.3");
    if (user.name.empty() && user.pose)
      throw UnusableInput("user frame", "its pose cannot be written into the program",
                          "name the system that is set to it on the machine: G54 to G59.3");
    constexpr int kMostTools = 100000;
    if (!frames.tool.name.empty() && !is_number(frames.tool.name, kMostTools))
      throw UnusableInput("tool " + frames.tool.name, "not a tool number",
                          "give the number in the machine's tool table");
  }

  void check(const Move& move) {
    ++waypoint_;
    if (move.kind == MotionKind::kCircular) fail("an arc", "give lines in place of it");
    if (move.kind == MotionKind::kJoint && move.joint_speed != 1)
      fail(fmt::format("a joint move at {:g} % of the axes' speed", 100 * move.joint_speed),
           "G0 runs at the machine's own speed: give joint_speed 1, and turn its override down");
    if (move.zone > 0 && move.zone < kSmallestTolerance)
      fail(fmt::format("zone {:g} m", move.zone), "give 0, or at least 0.001 mm");
    check_speed(move);
    if (before_ != nullptr) check_turn(move);
    before_ = &move;
  }

  void check_speed(const Move& move) const {
    if (move.kind == MotionKind::kJoint) return;
    const double said = std::round(move.speed / kFeedStep) * kFeedStep;
    if (said > 0 && std::abs(said - move.speed) <= settings_.max_speed_change * move.speed) return;
    fail(fmt::format("speed {:g} m/s", move.speed),
         "feeds have steps of 0.001 mm/min: give another one, or a greater max_speed_change");
  }

  void check_turn(const Move& move) const {
    const double angle = turn_between(*before_, move);
    if (dialect_.name() == "xyz" && angle > kSameTurn)
      fail(fmt::format("turned by {:.3g} degrees from the one before", angle * 180 / M_PI),
           "three axes keep the tool's direction: give a path with one orientation, or a dialect "
           "with rotary axes");
    const double tilt = std::acos(
        std::clamp(before_->pose.linear().col(2).dot(move.pose.linear().col(2)), -1.0, 1.0));
    const double way = dialect_.says_orientations() ? angle : tilt;
    if (dialect_.name() != "xyz" && way >= kOpenTurn)
      fail(fmt::format("turned by {:.1f} degrees from the one before", way * 180 / M_PI),
           "the direction of the turn is ambiguous: put a waypoint between the two");
  }

  void check(const SetOutput& output) const {
    if (output.output != "spindle" && output.output != "mist" && output.output != "flood" &&
        !is_number(output.output, kMostOutputs))
      throw UnusableInput("output " + output.output, "not a G-code output",
                          "give 0 to 63, spindle, mist or flood");
    if (before_ != nullptr && before_->zone > 0)
      fail("a zone where output " + output.output + " switches", "give it a zone of 0");
  }

  [[noreturn]] void fail(const std::string& value, const std::string& cure) const {
    throw UnusableInput("program " + program_.name + ", waypoint " + std::to_string(waypoint_),
                        value, cure);
  }

  const Program& program_;
  const WriteSettings& settings_;
  const GcodeDialect& dialect_;
  std::size_t waypoint_ = 0;
  const Move* before_ = nullptr;
};

}  // namespace

void check_for_gcode(const Program& program, const WriteSettings& settings,
                     const GcodeDialect& dialect) {
  check(program);
  Limits(program, settings, dialect).check();
}

}  // namespace tool_path_programs
