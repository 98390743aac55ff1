// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rapid_reader/rapid_reader.h"

#include <algorithm>
#include <cmath>

#include "rapid_reader/rapid_instructions.h"
#include "rapid_reader/rapid_passed_over.h"
#include "rapid_reader/source/rapid_values.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;

constexpr std::size_t kDeepestCall = 50;
constexpr std::size_t kMostStatements = 5000000;  // also limits nested calls
constexpr double kFullSpeed = 5000;  // [mm/s] of the tip, as vmax; joint speeds are shares of it

std::set<std::string> lower_cases(const std::set<std::string>& names) {
  std::set<std::string> result;
  for (const std::string& name : names)
    result.insert(lower_case(name));
  return result;
}

bool same(const Frame& one, const Frame& other) {
  if (one.name != other.name || one.pose.has_value() != other.pose.has_value()) return false;
  return !one.pose || one.pose->matrix() == other.pose->matrix();
}

class Reading {
 public:
  Reading(const std::vector<SourceFile>& files, const ReadSettings& settings)
      : without_motion_(lower_cases(settings.calls_without_motion)),
        source_(files),
        data_(source_, settings),
        passed_over_(source_, without_motion_, data_) {
    text_.files = files;
  }

  ProgramText run() {
    const RapidRoutine& first = source_.first_routine();
    text_.program.name = first.name;
    for (const RapidRoutine& routine : source_.routines())
      if (routine.kind != RapidRoutineKind::kProcedure)
        data_.forget_assigned(routine.body, routine.end, routine);
    run(first);
    return std::move(text_);
  }

 private:
  void run(const RapidRoutine& routine) {
    calls_.push_back(&routine);
    TokenReader reader = source_.reader(routine.file, routine.body);
    while (!finished_ && reader.position() < routine.end && !reader.at_name("ERROR") &&
           !reader.at_name("BACKWARD") && !reader.at_name("UNDO") && !reader.at_name("RETURN"))
      statement(reader, routine);
    calls_.pop_back();
  }

  void statement(TokenReader& reader, const RapidRoutine& routine) {
    if (++statements_ > kMostStatements)
      reader.fail("more than 5 million statements in their order", "give a shorter program");
    if (RapidPassedOver::begins_here(reader)) return passed_over_.pass_over(reader, routine);
    if (reader.at_name("GOTO")) reader.fail("GOTO", "give the program that moves in one order");
    if (reader.at_symbol('%'))
      reader.fail("a routine whose name is computed at run time", "call it by its name");
    if (at_rapid_assignment(reader)) return data_.assign(reader, routine);
    if (reader.at_name("CONNECT")) return pass_over_rapid_statement(reader);
    if (reader.at_name("EXIT")) {
      finished_ = true;
      return;
    }
    if (reader.peek_after().text == ":") {
      reader.name();
      reader.next();
      return;
    }
    const TokenReader where = reader;
    execute(read_rapid_call(reader), routine, where);
  }

  void execute(const RapidCall& call, const RapidRoutine& routine, const TokenReader& where) {
    if (const RapidMotion* motion = rapid_motion(call.name))
      return move(call, *motion, routine, where);
    if (const char* reason = rapid_unresolvable(call.name))
      where.fail(call.name + ", " + reason, "give a program whose poses are written in its text");
    const std::string key = lower_case(call.name);
    if (key == "setdo" || key == "set" || key == "reset")
      return set_output(call, key, routine, where);
    if (key == "cirpathmode") turns_otherwise_ = true;
    if (key == "velset") return set_speeds(call, routine, where);
    if (const RapidRoutine* called = source_.routine(call.name, routine))
      return follow(*called, where);
    if (rapid_moves_nothing(key) || without_motion_.count(key) != 0) return;
    where.fail("a call of " + call.name + ", which is not in the given files",
               "give its module, or name it as a routine without motion");
  }

  void follow(const RapidRoutine& called, const TokenReader& where) {
    if (called.kind != RapidRoutineKind::kProcedure)
      where.fail(called.name + ", which is not a PROC", "correct the program");
    if (std::find(calls_.begin(), calls_.end(), &called) != calls_.end())
      where.fail(called.name + " calls itself", "give a program without recursion");
    if (calls_.size() >= kDeepestCall)
      where.fail("calls nested deeper than 50", "give a program with fewer of them");
    run(called);
  }

  void set_output(const RapidCall& call, const std::string& key, const RapidRoutine& routine,
                  const TokenReader& where) {
    const bool value_given = key == "setdo";
    if (call.arguments.size() != (value_given ? 2 : 1))
      where.fail(call.name + " with " + std::to_string(call.arguments.size()) + " arguments",
                 "correct the program");
    const bool on = value_given ? data_.output_of(call.arguments[1], routine) : key == "set";
    add_output(call.arguments[0], on, routine, call.place);
  }

  void add_output(const RapidArgument& output, bool on, const RapidRoutine& routine,
                  const Place& place) {
    TokenReader reader = source_.reader(routine.file, output.begin);
    text_.program.steps.emplace_back(SetOutput{reader.name(), on});
    text_.steps.push_back({place, {}, {}});
  }

  void set_speeds(const RapidCall& call, const RapidRoutine& routine, const TokenReader& where) {
    if (call.arguments.size() != 2) where.fail("VelSet without its two numbers", "correct it");
    override_ = source_.reader(routine.file, call.arguments[0].begin).number().value / 100;
    most_ = source_.reader(routine.file, call.arguments[1].begin).number().value;
    if (!(override_ > 0) || !(most_ > 0)) where.fail("VelSet with a speed of 0", "correct it");
  }

  void move(const RapidCall& call, const RapidMotion& motion, const RapidRoutine& routine,
            const TokenReader& where) {
    const std::size_t vias = motion.kind == MotionKind::kCircular ? 1 : 0;
    const auto& arguments = call.arguments;
    if (arguments.size() < vias + 4 + motion.behind)
      where.fail(call.name + " with " + std::to_string(arguments.size()) + " arguments",
                 "it has " + std::to_string(vias + 4 + motion.behind) + " at least");
    const std::size_t tool = arguments.size() - motion.behind - 1;
    if (motion.joints) return move_joints(arguments[0], routine, call.place);
    Move move;
    StepText step{call.place, {}, {}};
    move.kind = motion.kind;
    if (vias == 1) {
      move.via = pose_at(arguments[0], routine, step.via);
      if (is_plain_arc(call)) step.arc = arc_text(call, tool, where);
    }
    move.pose = pose_at(arguments[vias], routine, step.pose);
    set_speed(move, speed_of(call, arguments[vias + 1], routine, where), where);
    move.zone = 1e-3 * zone_of(call, arguments[tool - 1], routine);
    move.frames = frames_of(call, arguments[tool], routine);
    text_.program.steps.emplace_back(move);
    text_.steps.push_back(step);
    if (motion.sets_output)
      add_output(arguments[tool + 1], data_.output_of(arguments[tool + 2], routine), routine,
                 call.place);
  }

  /// Whether an arc neither begins nor ends a process, has no time of its own, and turns the tool
  /// in the usual way.
  bool is_plain_arc(const RapidCall& call) const {
    static const std::set<std::string> plain = {"wobj", "v", "z"};
    const bool options =
        std::all_of(call.options.begin(), call.options.end(),
                    [](const auto& option) { return plain.count(option.first) > 0; });
    return options && !turns_otherwise_ && rapid_line_in_place_of(call.name) != nullptr;
  }

  /// @param tool index of the argument
  static ArcText arc_text(const RapidCall& call, std::size_t tool, TokenReader reader) {
    ArcText arc;
    arc.statement.begin = arc.word.begin = reader.offset();
    const auto begin = [&](std::size_t argument) {
      reader.go_to(call.arguments[argument].begin);
      return reader.offset();
    };
    const auto range = [&](std::size_t argument) {
      ByteRange range{begin(argument), 0};
      while (reader.position() < call.arguments[argument].end)
        reader.next();
      range.end = reader.end_of_last();
      return range;
    };
    reader.next();
    arc.word.end = reader.end_of_last();
    arc.via = {begin(0), begin(1)};
    arc.target = range(1);
    arc.zone = range(tool - 1);
    while (!reader.accept(';'))
      reader.next();
    arc.statement.end = reader.end_of_last();
    return arc;
  }

  void move_joints(const RapidArgument& target, const RapidRoutine& routine, const Place& place) {
    JointMove move;
    if (auto reader = data_.known_value_of(target, routine))
      move.joints = read_jointtarget(*reader);
    text_.program.steps.emplace_back(move);
    text_.steps.push_back({place, {}, {}});
  }

  /// One place in the text is one pose, however many moves use it.
  Eigen::Isometry3d pose_at(const RapidArgument& argument, const RapidRoutine& routine,
                            std::optional<std::size_t>& index) {
    TokenReader reader = data_.value_of(argument, routine);
    if (!reader.at_symbol('['))
      source_.reader(routine.file, argument.begin)
          .fail(std::string(reader.peek().text) + ", which is not a position", "give a robtarget");
    const Place place = reader.place();
    const std::size_t offset = reader.peek().offset;
    const auto [known, is_new] =
        pose_at_.emplace(std::pair(place.file, offset), text_.poses.size());
    index = known->second;
    if (is_new) text_.poses.push_back({read_rapid_pose(reader).pose(), place, offset});
    return text_.poses[*index].pose;
  }

  /// [mm/s]
  double speed_of(const RapidCall& call, const RapidArgument& argument, const RapidRoutine& routine,
                  const TokenReader& where) const {
    if (call.options.count("t") != 0)
      where.fail("a motion that is given by its time", "give it a speed");
    const auto own = call.options.find("v");
    const double speed = own == call.options.end()
                             ? data_.speed_of(argument, routine)
                             : source_.reader(routine.file, own->second.begin).number().value;
    return std::min(speed * override_, most_);
  }

  static void set_speed(Move& move, double speed, const TokenReader& where) {
    if (!(speed > 0)) where.fail("a speed that is not above 0", "give it a speed");
    if (move.kind == MotionKind::kJoint)
      move.joint_speed = std::min(1.0, speed / kFullSpeed);
    else
      move.speed = 1e-3 * speed;
  }

  /// [mm]
  double zone_of(const RapidCall& call, const RapidArgument& argument,
                 const RapidRoutine& routine) const {
    const auto own = call.options.find("z");
    if (own == call.options.end()) return data_.zone_of(argument, routine);
    return source_.reader(routine.file, own->second.begin).number().value;
  }

  std::size_t frames_of(const RapidCall& call, const RapidArgument& tool,
                        const RapidRoutine& routine) {
    Frames frames{data_.tool_of(tool, routine), {"wobj0", Eigen::Isometry3d::Identity()}};
    if (const auto user = call.options.find("wobj"); user != call.options.end())
      frames.user = data_.user_of(user->second, routine);
    auto& all = text_.program.frames;
    const auto found = std::find_if(all.rbegin(), all.rend(), [&](const Frames& known) {
      return same(known.tool, frames.tool) && same(known.user, frames.user);
    });
    if (found != all.rend()) return static_cast<std::size_t>(all.rend() - found) - 1;
    all.push_back(frames);
    return all.size() - 1;
  }

  const std::set<std::string> without_motion_;
  const RapidSource source_;
  RapidDataState data_;
  RapidPassedOver passed_over_;
  ProgramText text_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> pose_at_;  // file and byte to pose
  std::vector<const RapidRoutine*> calls_;
  std::size_t statements_ = 0;
  double override_ = 1;
  double most_ = kFullSpeed * 2;  // [mm/s] faster than any robot
  bool finished_ = false;
  bool turns_otherwise_ = false;  // along arcs: CirPathMode
};

}  // namespace

ProgramText read_rapid(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  return Reading(files, settings).run();
}

}  // namespace tool_path_programs
