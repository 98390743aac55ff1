// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "urscript/urscript_writer.h"

#include <fmt/format.h>

#include <array>
#include <set>

#include "scan_cell_common/errors/errors.h"
#include "text/number_text.h"
#include "text/rotation_vector.h"
#include "urscript/urscript_limits.h"

namespace tool_path_programs {
namespace {

constexpr std::size_t kLinesOfFunction = 250;
constexpr int kPoseDigits = 7;                      // 0.0001 mm, 0.000006 degree
constexpr const char* kLinearAcceleration = "1.2";  // [m/s^2] the manual's default
constexpr const char* kJointAcceleration = "1.4";   // [rad/s^2]

using Lines = std::vector<std::string>;

template <class Numbers>
std::string listed(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : ", ") + fixed(number, kPoseDigits);
  return "[" + text + "]";
}

std::string pose_text(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d position = pose.translation();
  const Eigen::Vector3d turn = rotation_vector(pose.linear());
  return "p" + listed(std::array<double, 6>{position.x(), position.y(), position.z(), turn.x(),
                                            turn.y(), turn.z()});
}

class Writer {
 public:
  Writer(const Program& program, const WriteSettings& settings)
      : program_(program),
        lines_(settings.max_lines == 0 ? kLinesOfFunction : settings.max_lines) {}

  WrittenProgram run() {
    for (const Step& step : program_.steps)
      add(step);
    note_settings();
    WrittenProgram written;
    written.files = {{program_.name + ".script", text()}};
    written.notes = notes_;
    return written;
  }

 private:
  void add(const Step& step) {
    if (const Move* move = std::get_if<Move>(&step)) return add(*move);
    const SetOutput& output = std::get<SetOutput>(step);
    const std::size_t mark = output.output.find('_');
    const std::string kind = mark == std::string::npos ? "standard" : output.output.substr(0, mark);
    const std::string number =
        mark == std::string::npos ? output.output : output.output.substr(mark + 1);
    body_.push_back(
        fmt::format("set_{}_digital_out({}, {})", kind, number, output.on ? "True" : "False"));
  }

  void add(const Move& move) {
    set_tool(program_.frames[move.frames].tool);
    const Frame& user = program_.frames[move.frames].user;
    const std::string speed =
        move.kind == MotionKind::kJoint
            ? fmt::format("a={}, v={}", kJointAcceleration,
                          shortest(move.joint_speed * kUrscriptJointSpeed, kUrscriptSpeedDigits))
            : fmt::format("a={}, v={}", kLinearAcceleration,
                          shortest(move.speed, kUrscriptSpeedDigits));
    const std::string zone =
        move.zone > 0 ? ", r=" + shortest(move.zone, kUrscriptSpeedDigits) : std::string();
    const std::string target = in_base(move.pose, user);
    if (move.kind == MotionKind::kCircular)
      body_.push_back(
          fmt::format("movec({}, {}, {}{})", in_base(*move.via, user), target, speed, zone));
    else if (move.kind == MotionKind::kLinear)
      body_.push_back(fmt::format("movel({}, {}{})", target, speed, zone));
    else
      body_.push_back(fmt::format("movej({}, {}{})", with_posture(move, target), speed, zone));
  }

  /// With the angles that the posture at the end of a joint move is nearest to.
  std::string with_posture(const Move& move, const std::string& target) {
    if (!move.joints) {
      posture_is_open_ = true;
      return target;
    }
    return fmt::format("get_inverse_kin({}, qnear={})", target, listed(*move.joints));
  }

  std::string in_base(const Eigen::Isometry3d& pose, const Frame& user) {
    const std::string text = pose_text(pose);
    const std::string frame = name_of(user);
    return frame.empty() ? text : fmt::format("pose_trans({}, {})", frame, text);
  }

  /// The variable that holds the frame; empty: poses are in the robot's base.
  std::string name_of(const Frame& user) {
    const std::string name = urscript_frame_name(user);
    if (name.empty()) return "";
    if (!user.pose)
      note(name +
           " is a variable of the controller: a feature of its installation that is variable");
    else if (known_frames_.insert(name).second)
      head_.push_back(fmt::format("global {} = {}", name, pose_text(*user.pose)));
    return name;
  }

  void set_tool(const Frame& tool) {
    if (!tool.pose)
      return note("the tool's tip (TCP) is the one that is active on the controller" +
                  (tool.name.empty() ? std::string() : ": choose " + tool.name));
    const std::string line = "set_tcp(" + pose_text(*tool.pose) + ")";
    if (line == tool_) return;
    tool_ = line;
    body_.push_back(line);
  }

  void note_settings() {
    note(fmt::format(
        "accelerations are the manual's defaults: {} m/s^2 along lines, {} rad/s^2 of joint moves",
        kLinearAcceleration, kJointAcceleration));
    if (posture_is_open_) note("joint moves end in the posture nearest to where the robot stands");
  }

  void note(const std::string& line) {
    if (known_notes_.insert(line).second) notes_.push_back(line);
  }

  std::string text() {
    std::string text = "def " + program_.name + "():\n";
    for (const std::string& comment : program_.comments)
      text += comment_text(comment);
    for (const std::string& line : head_)
      text += "  " + line + "\n";
    text += parts();
    for (const std::string& line : body_)
      text += "  " + line + "\n";
    return text + "end\n" + program_.name + "()\n";
  }

  static std::string comment_text(const std::string& comment) {
    std::string text = "  # ";
    for (const char character : comment)
      text += character == '\n' ? std::string("\n  # ") : std::string(character != '\r', character);
    return text + "\n";
  }

  /// Splits a main function that is too long into functions that it calls, and repeats this until
  /// there are few enough calls.
  std::string parts() {
    std::string text;
    std::size_t part = 0;
    const std::size_t statements = body_.size();
    while (body_.size() > lines_) {
      Lines calls;
      for (std::size_t first = 0; first < body_.size(); first += lines_) {
        const std::string name = fmt::format("{}_{}", program_.name, ++part);
        text += "  def " + name + "():\n";
        for (std::size_t i = first; i < std::min(first + lines_, body_.size()); ++i)
          text += "    " + body_[i] + "\n";
        text += "  end\n";
        calls.push_back(name + "()");
      }
      body_ = std::move(calls);
    }
    if (part > 0)
      note(fmt::format("{} statements in {} functions of at most {}", statements, part, lines_));
    return text;
  }

  const Program& program_;
  const std::size_t lines_;  // of a function
  Lines head_;               // before all functions
  Lines body_;               // in the order of the motion
  std::vector<std::string> notes_;
  std::set<std::string> known_notes_;
  std::set<std::string> known_frames_;
  std::string tool_;  // the last set_tcp statement
  bool posture_is_open_ = false;
};

}  // namespace

WrittenProgram write_urscript(const Program& program, const WriteSettings& settings) {
  using scan_cell_common::InvalidParameter;
  if (settings.max_lines == 1)
    throw InvalidParameter("max_lines", "1", "give at least 2, or 0 for what controllers take");
  if (!settings.dialect.empty())
    throw InvalidParameter("dialect", settings.dialect, "URScript has none: leave it out");
  check_for_urscript(program, settings);
  return Writer(program, settings).run();
}

}  // namespace tool_path_programs
