// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript_reader/urscript_recorder.h"

#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"
#include "urscript_reader/urscript_names.h"

namespace tool_path_programs {
namespace {

using Kind = ScriptValue::Kind;

// The manual's defaults for arguments that a call leaves out.
constexpr double kDefaultSpeed = 0.25;       // [m/s]
constexpr double kDefaultJointSpeed = 1.05;  // [rad/s] of the leading axis

// [rad/s] taken as the full speed of an axis: 180 degrees a second.
constexpr double kAxisSpeed = M_PI;

std::string key_of(const std::string& name, const PoseLiteral* literal) {
  if (literal == nullptr) return name;
  return name + "@" + std::to_string(literal->place.file) + ":" + std::to_string(literal->offset);
}

}  // namespace

ScriptRecorder::ScriptRecorder(const std::vector<SourceFile>& files, const ReadSettings& settings)
    : settings_(settings) {
  text_.files = files;
}

ProgramText ScriptRecorder::done(const std::string& name) {
  text_.program.name = name;
  return std::move(text_);
}

bool ScriptRecorder::record(const std::string& function, const ScriptArguments& arguments,
                            const Place& place, const ByteRange& call) {
  place_ = place;
  call_ = call;
  if (function == "movej" || function == "movel" || function == "movep") {
    move(function, arguments);
  } else if (function == "movec") {
    arc(arguments);
  } else if (function == "set_tcp") {
    set_tool(arguments);
  } else if (is_urscript_function_with_motion(function)) {
    fail(function + " does not move to a pose", "give a program of movej, movel, movep and movec");
  } else {
    return output(function, arguments);
  }
  return true;
}

void ScriptRecorder::move(const std::string& function, const ScriptArguments& arguments) {
  const ScriptValue* target = arguments.find("pose", 0);
  if (target == nullptr) target = arguments.find("q", 0);
  if (target == nullptr) fail(function + " without a target", "give the pose");
  if (target->is(Kind::kJoints)) {
    text_.program.steps.emplace_back(JointMove{target->joints});
    text_.steps.push_back({place_, {}, {}});
    return;
  }
  Move move;
  move.kind = function == "movej" ? MotionKind::kJoint : MotionKind::kLinear;
  constexpr std::size_t kTime = 3;
  const bool has_time = function != "movep";
  const ScriptValue* time = has_time ? arguments.find("t", kTime) : nullptr;
  if (number(time, 0, "time") != 0)
    fail("a time for the way instead of a speed", "give v, and leave t out");
  set_speed(move, arguments, 2);
  set_zone(move, arguments, has_time ? kTime + 1 : kTime);
  if (target->joints.size() == 6) {
    move.joints.emplace();
    std::copy(target->joints.begin(), target->joints.end(), move.joints->begin());
  }
  add(move, *target, nullptr);
}

void ScriptRecorder::arc(const ScriptArguments& arguments) {
  const ScriptValue* via = arguments.find("pose_via", 0);
  const ScriptValue* target = arguments.find("pose_to", 1);
  if (via == nullptr || target == nullptr)
    fail("movec without a via or a target", "give both poses");
  Move move;
  move.kind = MotionKind::kCircular;
  set_speed(move, arguments, 3);
  set_zone(move, arguments, 4);
  add(move, *target, via);
  const ScriptValue* const mode = arguments.find("mode", 5);  // 1: turns with the arc
  const bool plain = mode == nullptr || (mode->is(Kind::kNumber) && mode->number == 0);
  if (plain) text_.steps.back().arc = ArcText{call_, {}, {}, {}, {}};
}

void ScriptRecorder::set_speed(Move& move, const ScriptArguments& arguments,
                               std::size_t position) const {
  const bool joint = move.kind == MotionKind::kJoint;
  const double speed =
      number(arguments.find("v", position), joint ? kDefaultJointSpeed : kDefaultSpeed, "speed");
  if (!(speed > 0)) fail("speed " + shortest(speed, 6), "give a speed above 0");
  (joint ? move.joint_speed : move.speed) = joint ? speed / kAxisSpeed : speed;
}

void ScriptRecorder::set_zone(Move& move, const ScriptArguments& arguments,
                              std::size_t position) const {
  move.zone = number(arguments.find("r", position), 0, "blend radius");
  if (!(move.zone >= 0)) fail("blend radius " + shortest(move.zone, 6), "give one from 0 up");
}

void ScriptRecorder::add(Move move, const ScriptValue& target, const ScriptValue* via) {
  StepText step{place_, {}, {}};
  if (via != nullptr) {
    step.via = pose_of(*via);
    move.via = text_.poses[*step.via].pose;
  }
  step.pose = pose_of(target);
  move.pose = text_.poses[*step.pose].pose;
  move.frames = frames_of(target);
  if (via != nullptr && frames_of(*via) != move.frames)
    fail("via and target in two frames", "give both in one frame");
  text_.program.steps.emplace_back(move);
  text_.steps.push_back(step);
}

std::size_t ScriptRecorder::pose_of(const ScriptValue& value) {
  const std::string name = value.name.empty() ? "its target" : value.name;
  if (value.is(Kind::kFree))
    fail(name + " is not in the files", "give the program that holds its numbers");
  if (!value.is(Kind::kPose) || !value.pose.has_numbers)
    fail(name + " is computed", "give it as p[x, y, z, rx, ry, rz] in numbers");
  const LiteralId id{value.pose.place.file, value.pose.offset};
  if (frame_literals_.count(id) != 0)
    fail(name + " is a frame and a target", "write its numbers once for each");
  const auto [at, added] = poses_.try_emplace(id, text_.poses.size());
  if (added) text_.poses.push_back({value.pose.pose, value.pose.place, value.pose.offset});
  return at->second;
}

void ScriptRecorder::use_as_frame(const PoseLiteral& literal) {
  const LiteralId id{literal.place.file, literal.offset};
  if (poses_.count(id) != 0)
    fail("a pose is a frame and a target", "write its numbers once for each");
  frame_literals_.insert(id);
}

std::size_t ScriptRecorder::frames_of(const ScriptValue& target) {
  const PoseLiteral* literal = target.user_literal ? &*target.user_literal : nullptr;
  if (literal != nullptr) use_as_frame(*literal);
  const auto [at, added] = frames_.try_emplace({tool_key_, key_of(target.user.name, literal)},
                                               text_.program.frames.size());
  if (added) {
    Frame user = target.user;
    const auto known = settings_.frames.find(user.name);
    if (!user.pose && known != settings_.frames.end()) user.pose = known->second;
    if (user.name.empty() && !user.pose) user.pose = Eigen::Isometry3d::Identity();
    text_.program.frames.push_back({tool_, user});
  }
  return at->second;
}

void ScriptRecorder::set_tool(const ScriptArguments& arguments) {
  const ScriptValue* tool = arguments.find("pose", 0);
  if (tool == nullptr) fail("set_tcp without a pose", "give the tool's pose");
  const bool is_frame = tool->is(Kind::kFree) ||
                        (tool->is(Kind::kPose) && !tool->user_literal && tool->user.name.empty());
  if (!is_frame) fail("the tool frame is computed", "give it as p[x, y, z, rx, ry, rz]");
  tool_ = {tool->name, {}};
  const bool is_literal = tool->is(Kind::kPose);
  if (is_literal) {
    use_as_frame(tool->pose);
    tool_.pose = tool->pose.pose;
  } else if (settings_.frames.count(tool->name) != 0) {
    tool_.pose = settings_.frames.at(tool->name);
  }
  tool_key_ = key_of(tool->name, is_literal ? &tool->pose : nullptr);
}

bool ScriptRecorder::output(const std::string& function, const ScriptArguments& arguments) {
  const bool is_standard = function == "set_digital_out" || function == "set_standard_digital_out";
  const bool is_tool = function == "set_tool_digital_out";
  if (!is_standard && !is_tool && function != "set_configurable_digital_out") return false;
  const ScriptValue* which = arguments.find("n", 0);
  const ScriptValue* state = arguments.find("b", 1);
  if (which == nullptr || !which->is(Kind::kNumber) || state == nullptr || !state->is(Kind::kTruth))
    fail(function + " of a number or a state that is computed", "give a number, and True or False");
  constexpr double kFirstOfTool = 8;  // of set_digital_out, from the manual
  const double number = which->number;
  std::string name = is_tool ? "tool_" : is_standard ? "" : "configurable_";
  if (function == "set_digital_out" && number >= kFirstOfTool)
    name = "tool_" + shortest(number - kFirstOfTool, 3);
  else
    name += shortest(number, 3);
  text_.program.steps.emplace_back(SetOutput{name, state->number != 0});
  text_.steps.push_back({place_, {}, {}});
  return true;
}

double ScriptRecorder::number(const ScriptValue* value, double otherwise,
                              const std::string& what) const {
  if (value == nullptr) return otherwise;
  if (!value->is(Kind::kNumber))
    fail((value->name.empty() ? "a " + what : value->name) + " that only the controller knows",
         "give the " + what + " as a number, or as a variable that the program sets to one");
  return value->number;
}

void ScriptRecorder::fail(const std::string& value, const std::string& cure) const {
  throw scan_cell_common::UnusableInput(to_string(place_, text_.files), value, cure);
}

}  // namespace tool_path_programs
