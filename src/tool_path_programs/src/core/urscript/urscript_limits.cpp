// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript/urscript_limits.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "program/turn.h"
#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"
#include "urscript_reader/urscript_names.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::UnusableInput;

constexpr int kOutputs = 8;  // standard ones, and as many configurable ones
constexpr int kToolOutputs = 2;

/// The move before, and its waypoint.
struct Before {
  const Move* move = nullptr;
  std::size_t waypoint = 0;
};

constexpr double kSameDistance = 1e-9;  // [m]
constexpr double kSpeedStep = 1e-6;
static_assert(kUrscriptSpeedDigits == 6);

double rounded(double speed) {
  return std::round(speed / kSpeedStep) * kSpeedStep;
}

bool same_frame(const Frame& one, const Frame& other) {
  return one.name == other.name && one.pose.has_value() == other.pose.has_value() &&
         (!one.pose || one.pose->isApprox(*other.pose, 0));
}

class Limits {
 public:
  Limits(const Program& program, const WriteSettings& settings)
      : program_(program), settings_(settings) {}

  void check() {
    check_names();
    for (const Step& step : program_.steps) {
      if (const Move* move = std::get_if<Move>(&step))
        check(*move);
      else if (const SetOutput* output = std::get_if<SetOutput>(&step))
        check(*output);
      else
        throw UnusableInput(waypoint(), "a move to angles of the axes",
                            "give the pose that it leads to");
    }
    if (before_.move && before_.move->zone > 0)
      throw UnusableInput(waypoint(), "the last waypoint has a zone, but no move follows it",
                          "give it a zone of 0");
  }

 private:
  void check_names() const {
    check_name("program " + program_.name, program_.name);
    std::map<std::string, const Frame*> known;
    for (const Frames& frames : program_.frames) {
      const std::string name = urscript_frame_name(frames.user);
      if (name.empty()) continue;
      check_name("user frame " + name, name);
      const auto [at, added] = known.try_emplace(name, &frames.user);
      if (!added && !same_frame(*at->second, frames.user))
        throw UnusableInput("user frame " + name, "two places have this name",
                            "give each frame its own name");
      if (is_function(name))
        throw UnusableInput("user frame " + name, "named as a function of the program",
                            "give one of them another name");
    }
  }

  /// ADAPTED, ADAPTED_1
  bool is_function(const std::string& name) const {
    if (name.rfind(program_.name, 0) != 0) return false;
    const std::string rest = name.substr(program_.name.size());
    return rest.empty() ||
           (rest[0] == '_' && rest.find_first_not_of("0123456789", 1) == std::string::npos);
  }

  static void check_name(const std::string& thing, const std::string& name) {
    const std::string fault = fault_of_urscript_name(name);
    if (!fault.empty())
      throw UnusableInput(thing, fault, "name it " + urscript_name_like(name) + ", for example");
  }

  void check(const Move& move) {
    ++waypoint_;
    check_way(move);
    check_speed(move);
    if (move.zone > 0 && rounded(move.zone) <= 0)
      throw UnusableInput(waypoint(), fmt::format("zone {:g} m", move.zone),
                          "give a zone of 0, or of at least 0.001 mm");
    before_ = {&move, waypoint_};
  }

  /// Checks the way from the waypoint before.
  void check_way(const Move& move) const {
    if (!before_.move) {
      if (move.kind == MotionKind::kCircular)
        throw UnusableInput(waypoint(), "an arc as the first move",
                            "a move to the beginning of the arc must come before it");
      return;
    }
    const Frames& frames = program_.frames[move.frames];
    const Frames& frames_before = program_.frames[before_.move->frames];
    if (!same_frame(frames.tool, frames_before.tool) && before_.move->zone > 0)
      throw UnusableInput(before(), "a zone where the tool frame changes", "give it a zone of 0");
    if (!same_frame(frames.user, frames_before.user)) return;
    check_turn(move);
    check_blend(move);
  }

  void check_turn(const Move& move) const {
    if (move.kind == MotionKind::kJoint) return;
    const double angle = turn_between(*before_.move, move);
    if (angle >= kOpenTurn)
      throw UnusableInput(
          waypoint(),
          fmt::format("turned by {:.1f} degrees from the one before", angle * 180 / M_PI),
          "the direction of the turn is ambiguous: put a waypoint between the two");
  }

  /// Refuses zones that overlap: the controller would leave out a blend, or stop.
  void check_blend(const Move& move) const {
    const double distance = (move.pose.translation() - before_.move->pose.translation()).norm();
    if (before_.move->zone == 0 && move.zone == 0) return;
    if (before_.move->zone + move.zone <= distance + kSameDistance) return;
    throw UnusableInput(
        before() + fmt::format(" and {}", waypoint_),
        fmt::format("{:.4g} mm apart with zones of {:.4g} mm and {:.4g} mm", 1e3 * distance,
                    1e3 * before_.move->zone, 1e3 * move.zone),
        fmt::format("give zones of at most {} mm: zones of neighbours must not overlap",
                    largest_zone()));
  }

  /// [mm] the largest zone possible at all waypoints where the tool does not stop.
  std::string largest_zone() const {
    double zone = std::numeric_limits<double>::infinity();
    const auto moves = moves_of(program_);
    for (std::size_t i = 1; i < moves.size(); ++i) {
      const double zones = (moves[i - 1]->zone > 0 ? 1 : 0) + (moves[i]->zone > 0 ? 1 : 0);
      if (zones > 0)
        zone = std::min(
            zone, (moves[i]->pose.translation() - moves[i - 1]->pose.translation()).norm() / zones);
    }
    return fixed(std::floor(1e6 * (zone + kSameDistance)) * 1e-3, 3);
  }

  void check_speed(const Move& move) const {
    const bool joint = move.kind == MotionKind::kJoint;
    const double speed = joint ? move.joint_speed * kUrscriptJointSpeed : move.speed;
    const double said = rounded(speed);
    if (said > 0 && std::abs(said - speed) <= settings_.max_speed_change * speed) return;
    throw UnusableInput(
        waypoint(), fmt::format("speed {:g} {}", speed, joint ? "rad/s" : "m/s"),
        fmt::format("speeds have steps of {:g}: give another one, or a greater max_speed_change",
                    kSpeedStep));
  }

  void check(const SetOutput& output) const {
    if (!is_output(output.output))
      throw UnusableInput("output " + output.output, "not a digital output of the controller",
                          "give 0 to 7, configurable_0 to configurable_7, tool_0 or tool_1");
    if (before_.move && before_.move->zone > 0)
      throw UnusableInput(before(), "a zone where output " + output.output + " switches",
                          "give it a zone of 0: within a zone the output switches too early");
  }

  static bool is_output(const std::string& output) {
    const auto is_one_of = [&](const std::string& kind, int count) {
      return output.size() == kind.size() + 1 && output.rfind(kind, 0) == 0 &&
             output.back() >= '0' && output.back() < '0' + count;
    };
    return is_one_of("", kOutputs) || is_one_of("configurable_", kOutputs) ||
           is_one_of("tool_", kToolOutputs);
  }

  std::string waypoint() const { return waypoint(waypoint_); }
  std::string before() const { return waypoint(before_.waypoint); }
  std::string waypoint(std::size_t number) const {
    return "program " + program_.name + ", waypoint " + std::to_string(number);
  }

  const Program& program_;
  const WriteSettings& settings_;
  std::size_t waypoint_ = 0;
  Before before_;
};

}  // namespace

std::string urscript_frame_name(const Frame& user) {
  return user.name.empty() && user.pose ? "part_frame" : user.name;
}

void check_for_urscript(const Program& program, const WriteSettings& settings) {
  check(program);
  Limits(program, settings).check();
}

}  // namespace tool_path_programs
