// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "krl_reader/krl_motions.h"

#include <utility>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;
using scan_cell_common::UnusableInput;

const char* const kGiveLiteral = "only poses written in the files as numbers can be adapted";

/// Two frames are the same if names and places are identical to the last bit.
std::string key_of(const Frame& frame) {
  std::string key = frame.name + '\n';
  if (frame.pose)
    key.append(reinterpret_cast<const char*>(frame.pose->matrix().data()), 16 * sizeof(double));
  return key + '\n';
}

MotionKind kind_of(const std::string& word) {
  if (word == "circ" || word == "scirc") return MotionKind::kCircular;
  return word == "lin" || word == "slin" ? MotionKind::kLinear : MotionKind::kJoint;
}

JointMove joints_of(const KrlAggregate& axes) {
  JointMove move;
  for (const char group : {'a', 'e'})
    for (char axis = '1'; axis <= '6'; ++axis)
      if (const auto angle = axes.number({group, axis})) move.joints.push_back(*angle);
  return move;
}

/// These positions are in $CONFIG.DAT, which belongs to the robot and not to the program.
bool is_home(const std::string& name) {
  return name.rfind("xhome", 0) == 0 || name == "$h_pos";
}

}  // namespace

void KrlMotions::move(const std::string& word, const Place& place, TokenReader& reader) {
  const MotionKind kind = kind_of(word);
  const KrlSettings before = setter_.settings;
  std::optional<KrlAggregate> via;
  ArcText arc;
  arc.word = {reader.end_of_last() - word.size(), reader.end_of_last()};
  if (kind == MotionKind::kCircular) {
    arc.via.begin = reader.offset();
    const Target way = target(reader);
    reader.expect(',');
    arc.via.end = reader.offset();
    if (!way.pose) reader.fail("an arc through angles of the axes", "give a pose there");
    via = way.pose;
  }
  arc.target.begin = reader.offset();
  const Target end = target(reader);
  arc.target.end = reader.end_of_last();
  bool flies = false;
  read_behind(reader, flies);
  arc.statement = {arc.word.begin, reader.end_of_last()};
  if (!end.stays && !end.pose && kind != MotionKind::kJoint)
    reader.fail("a line or arc to angles of the axes", "give a pose there, or PTP");
  if (end.pose) add_pose_move(kind, via, *end.pose, flies, place);
  const bool triggers = std::exchange(triggered_, false);
  if (end.pose && via && !triggers) {
    if (!turns_otherwise_) turns_otherwise_ = mentions(text_.files, {"$circ_type", "$ori_type"});
    if (!*turns_otherwise_) text_.steps.back().arc = arc;
  }
  if (end.joints) add_axes_move(*end.joints, place);
  add_waiting_outputs();
  setter_.settings = before;
}

KrlMotions::Target KrlMotions::target(TokenReader& reader) {
  Target found;
  if (reader.at_symbol('{')) {
    const KrlAggregate literal = read_aggregate(reader);
    if (literal.has_axes())
      found.joints = joints_of(literal);
    else
      found.pose = literal;
  } else {
    found = named_target(reader);
  }
  if (reader.at_symbol(':')) reader.fail("a pose that is computed with ':'", kGiveLiteral);
  return found;
}

KrlMotions::Target KrlMotions::named_target(TokenReader& reader) {
  Target found;
  const std::string where = reader.where();
  const std::string written(reader.peek().text);
  const std::string name = read_variable(reader);
  found.stays = name == "$axis_act" || name == "$pos_act" || name == "$axis_act_meas";
  if (found.stays) return found;
  const KrlValue* value = name.empty() ? nullptr : variables_.find(name);
  if (value && value->aggregate && value->aggregate->has_axes()) {
    found.joints = joints_of(*value->aggregate);
  } else if (value && value->aggregate) {
    found.pose = value->aggregate;
  } else if (is_home(name)) {
    found.joints = JointMove{};
  } else {
    throw UnusableInput(where,
                        "the pose " + written +
                            (value ? " is computed in line " + std::to_string(value->place.line)
                                   : " is not in the files"),
                        value ? kGiveLiteral : "give the .dat file that holds it");
  }
  return found;
}

/// Reads C_DIS, C_PTP and WITH, which hold for this motion only, and CA.
void KrlMotions::read_behind(TokenReader& reader, bool& flies) {
  while (!reader.at_line_end()) {
    if (reader.accept(',')) {
      if (reader.at_name("ca"))
        reader.fail("an arc that ends by its angle (CA)", "give the end as a pose");
    } else if (reader.accept("with")) {
      setter_.with(reader);
    } else {
      if (reader.at_symbol('.') || reader.at_symbol('+') || reader.at_symbol('-'))
        reader.fail("a pose that is computed", kGiveLiteral);
      flies = flies || reader.at_name("c_dis") || reader.at_name("c_spl");
      reader.next();
    }
  }
}

void KrlMotions::add_pose_move(MotionKind kind, const std::optional<KrlAggregate>& via,
                               const KrlAggregate& pose, bool flies, const Place& place) {
  Move move;
  move.kind = kind;
  move.frames = frames_index();
  StepText step{place, {}, {}};
  if (via) {
    step.via = pose_text(*via, move.frames, place);
    move.via = text_.poses[*step.via].pose;
  }
  step.pose = pose_text(pose, move.frames, place);
  move.pose = text_.poses[*step.pose].pose;
  if (setter_.settings.speed) move.speed = *setter_.settings.speed;
  if (setter_.settings.joint_speed) move.joint_speed = *setter_.settings.joint_speed;
  move.zone = flies ? setter_.settings.zone : 0;
  last_pose_ = step.pose;
  last_frames_ = move.frames;
  text_.program.steps.emplace_back(move);
  text_.steps.push_back(step);
}

void KrlMotions::add_axes_move(const JointMove& move, const Place& place) {
  last_pose_.reset();
  text_.program.steps.emplace_back(move);
  text_.steps.push_back({place, {}, {}});
}

void KrlMotions::set_output(const SetOutput& output, const Place& place) {
  text_.program.steps.emplace_back(output);
  text_.steps.push_back({place, {}, {}});
}

void KrlMotions::set_output_behind_next(const SetOutput& output, const Place& place) {
  waiting_.emplace_back(output, place);
}

void KrlMotions::add_waiting_outputs() {
  for (const auto& [output, place] : waiting_)
    set_output(output, place);
  waiting_.clear();
}

/// Adds a literal; the numbers that it leaves out come from the end of the last motion.
std::size_t KrlMotions::pose_text(const KrlAggregate& literal, std::size_t frames,
                                  const Place& place) {
  const std::string where = to_string(place, text_.files);
  KrlNumbers others{};
  if (!literal.has_pose()) throw UnusableInput(where, "a pose without X, Y, Z", kGiveLiteral);
  for (std::size_t field = 0; field < kKrlFields.size(); ++field)
    if (literal.words.count(lower_case(kKrlFields[field])) > 0)
      throw UnusableInput(where, std::string(kKrlFields[field]) + " is not a number", kGiveLiteral);
  if (!literal.whole()) {
    if (!last_pose_ || last_frames_ != frames)
      throw UnusableInput(where, "a pose without all of X, Y, Z, A, B, C, and none before it",
                          "give all six");
    others = krl_numbers(text_.poses[*last_pose_].pose);
  }
  const Eigen::Isometry3d pose = krl_pose(literal.over(others));
  if (!pose.matrix().allFinite())
    throw UnusableInput(where, "a pose beyond all limits", "correct it");
  const auto [known, is_new] =
      poses_.insert({{literal.place.file, literal.offset}, text_.poses.size()});
  if (is_new) {
    text_.poses.push_back({pose, literal.place, literal.offset});
  } else if (!text_.poses[known->second].pose.isApprox(pose, 1e-12)) {
    throw UnusableInput(where, "a pose whose place differs each time", "give all six numbers");
  }
  return known->second;
}

std::size_t KrlMotions::frames_index() {
  const Frames& frames = setter_.settings.frames;
  const auto [known, is_new] =
      frames_.insert({key_of(frames.tool) + key_of(frames.user), text_.program.frames.size()});
  if (is_new) text_.program.frames.push_back(frames);
  return known->second;
}

}  // namespace tool_path_programs
