// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_reader.h"

#include <algorithm>
#include <set>

#include "fanuc_reader/fanuc_angles.h"
#include "fanuc_reader/fanuc_flow.h"
#include "fanuc_reader/fanuc_motion.h"
#include "fanuc_reader/fanuc_statements.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using Kind = FanucStatementKind;
using scan_cell_common::lower_case;

constexpr std::size_t kMostStatements = 5000000;  // also limits nested calls

std::set<std::string> lower_cases(const std::set<std::string>& names) {
  std::set<std::string> result;
  for (const std::string& name : names)
    result.insert(lower_case(name));
  return result;
}

class Reading {
 public:
  Reading(const std::vector<SourceFile>& files, const ReadSettings& settings)
      : settings_(settings),
        without_motion_(lower_cases(settings.calls_without_motion)),
        source_(files),
        flow_(source_, without_motion_) {
    text_.files = files;
  }

  ProgramText run() {
    if (source_.programs().empty())
      throw scan_cell_common::UnusableInput("program", "no file", "give the program's file");
    text_.program.name = source_.programs().front().name;
    run(source_.programs().front());
    return std::move(text_);
  }

 private:
  void run(const FanucProgram& program) {
    if (checked_.insert(&program).second) flow_.check(program);
    calls_.push_back(&program);
    for (const FanucStatement& statement : program.statements) {
      if (statement.kind == Kind::kBegin) ++conditions_;
      if (statement.kind == Kind::kEnd) --conditions_;
      if (conditions_ > 0) continue;
      TokenReader reader = source_.reader(program.file, statement.begin);
      if (++statements_ > kMostStatements)
        reader.fail("more than 5 million statements in their order", "give a shorter program");
      if (statement.kind == Kind::kStop) {
        finished_ = finished_ || lower_case(reader.peek().text) == "abort";
        break;
      }
      execute(statement, program, reader);
      if (finished_) break;
    }
    calls_.pop_back();
  }

  void execute(const FanucStatement& statement, const FanucProgram& program, TokenReader& reader) {
    if (statement.kind == Kind::kMotion) move(statement, program, reader);
    if (statement.kind == Kind::kFrame) select_frame(reader);
    if (statement.kind == Kind::kOutput) set_output(reader);
    if (statement.kind == Kind::kCall) follow(reader);
    if (statement.kind == Kind::kChanged) forget_position(program, reader);
  }

  void follow(TokenReader& reader) {
    const TokenReader where = reader;
    reader.expect("CALL");
    const std::string name = reader.name();
    const FanucProgram* called = source_.program(name);
    if (!called) {
      flow_.moves(name, where);  // refuses unknown programs
      return;
    }
    if (std::find(calls_.begin(), calls_.end(), called) != calls_.end())
      where.fail(name + " calls itself", "give a program without recursion");
    if (calls_.size() >= kDeepestFanucCall)
      where.fail("calls nested deeper than 50", "give a program with fewer of them");
    run(*called);
  }

  void forget_position(const FanucProgram& program, TokenReader& reader) {
    reader.expect("P");
    const auto index = read_fanuc_index(reader);
    if (!index)
      reader.fail("a position whose number only a running program knows", "give it a number");
    changed_[{&program, *index}] = reader.place().line;
  }

  void select_frame(TokenReader& reader) {
    const TokenReader where = reader;
    const std::string name = lower_case(reader.name());
    const bool user = name.compare(0, 6, "uframe") == 0;
    std::optional<int>& selected = user ? user_ : tool_;
    if (name == "uframe" || name == "utool") return change_frame(user, where);
    if (reader.at_symbol('[')) read_fanuc_index(reader);
    reader.expect('=');
    if (reader.peek().kind != TokenKind::kNumber)
      where.fail("a frame whose number only a running program knows", "select it by its number");
    selected = static_cast<int>(reader.number().value);
  }

  /// UFRAME[1]=PR[2]: the frame's place is unknown, so it must not change between motions.
  void change_frame(bool user, const TokenReader& where) {
    if (user && !text_.program.frames.empty())
      where.fail("a frame that is moved between motions", "give a program with fixed frames");
  }

  void set_output(TokenReader& reader) {
    const TokenReader where = reader;
    const std::string kind = lower_case(reader.name());
    const auto index = read_fanuc_index(reader);
    reader.expect('=');
    if (reader.at_name("PULSE")) return;
    const bool on = reader.at_name("ON");
    if (!index || !(on || reader.at_name("OFF")))
      where.fail("an output that is computed at run time", "give a number and ON or OFF");
    const std::string number = std::to_string(*index);
    text_.program.steps.emplace_back(SetOutput{kind == "do" ? number : "RO[" + number + "]", on});
    text_.steps.push_back({where.place(), {}, {}});
  }

  void move(const FanucStatement& statement, const FanucProgram& program, TokenReader& reader) {
    const TokenReader where = reader;
    const FanucMotion motion = read_fanuc_motion(reader, statement.end);
    const FanucPosition& target = position(motion.target, program, where);
    if (!target.joints.empty()) {
      text_.program.steps.emplace_back(JointMove{target.joints});
      text_.steps.push_back({where.place(), {}, {}});
      return;
    }
    Move move;
    StepText step{where.place(), {}, {}};
    move.kind = motion.kind;
    if (motion.via) {
      step.via = pose(*motion.via, position(*motion.via, program, where), program, where);
      move.via = text_.poses[*step.via].pose;
      step.arc = motion.arc;
    }
    step.pose = pose(motion.target, target, program, where);
    move.pose = text_.poses[*step.pose].pose;
    (move.kind == MotionKind::kJoint ? move.joint_speed : move.speed) = motion.speed;
    move.zone = motion.zone;
    move.frames = frames_of(target, where);
    text_.program.steps.emplace_back(move);
    text_.steps.push_back(step);
  }

  const FanucPosition& position(int index, const FanucProgram& program,
                                const TokenReader& where) const {
    const std::string name = "P[" + std::to_string(index) + "]";
    if (const auto changed = changed_.find({&program, index}); changed != changed_.end())
      where.fail(name + " is computed at run time, in line " + std::to_string(changed->second),
                 "write it into the program as numbers");
    const auto found = program.positions.find(index);
    if (found == program.positions.end())
      where.fail(name + " is not in /POS", "give all of the program");
    return found->second;
  }

  std::size_t pose(int index, const FanucPosition& position, const FanucProgram& program,
                   const TokenReader& where) {
    const auto [known, is_new] = pose_at_.emplace(std::pair(&program, index), text_.poses.size());
    if (!is_new) return known->second;
    FanucPose numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!position.pose[i])
        where.fail("P[" + std::to_string(index) + "] was not taught", "give it all numbers");
      numbers[i] = position.pose[i]->value;
    }
    text_.poses.push_back({pose_of(numbers), {program.file, position.line}, position.offset});
    return known->second;
  }

  std::size_t frames_of(const FanucPosition& position, const TokenReader& where) {
    check_selected(position.user_frame, user_, "user frame", where);
    check_selected(position.tool, tool_, "tool", where);
    const Frames frames{frame(position.tool ? position.tool : tool_, true),
                        frame(position.user_frame ? position.user_frame : user_, false)};
    auto& all = text_.program.frames;
    const auto found = std::find_if(all.begin(), all.end(), [&](const Frames& known) {
      return known.tool.name == frames.tool.name && known.user.name == frames.user.name;
    });
    if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
    all.push_back(frames);
    return all.size() - 1;
  }

  static void check_selected(const std::optional<int>& own, const std::optional<int>& selected,
                             const std::string& thing, const TokenReader& where) {
    if (own && selected && *own != *selected)
      where.fail("a position in " + thing + " " + std::to_string(*own) + " while " +
                     std::to_string(*selected) + " is selected",
                 "select that of the position");
  }

  Frame frame(const std::optional<int>& number, bool tool) const {
    if (!number) return {};
    Frame frame{std::to_string(*number), std::nullopt};
    const auto given = settings_.frames.find(frame.name);
    if (*number == 0)
      frame.pose = Eigen::Isometry3d::Identity();
    else if (!tool && given != settings_.frames.end())
      frame.pose = given->second;
    return frame;
  }

  const ReadSettings& settings_;
  const std::set<std::string> without_motion_;
  const FanucSource source_;
  FanucFlow flow_;
  ProgramText text_;
  std::set<const FanucProgram*> checked_;
  std::vector<const FanucProgram*> calls_;
  std::map<std::pair<const FanucProgram*, int>, std::size_t> changed_;  // line of the change
  std::map<std::pair<const FanucProgram*, int>, std::size_t> pose_at_;
  std::optional<int> user_;
  std::optional<int> tool_;
  std::size_t statements_ = 0;
  int conditions_ = 0;
  bool finished_ = false;
};

}  // namespace

ProgramText read_fanuc(const std::vector<SourceFile>& files, const ReadSettings& settings) {
  return Reading(files, settings).run();
}

}  // namespace tool_path_programs
