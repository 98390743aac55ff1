// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "pdl2_reader/pdl2_run.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "text/arc_statement.h"

namespace tool_path_programs {
namespace {

using scan_cell_common::lower_case;
using scan_cell_common::UnusableInput;

const char* const kGiveLiteral = "only poses written in the files as numbers can be adapted";

std::string key_of(const Frame& frame) {
  std::string key = frame.name + '\n';
  if (frame.pose)
    key.append(reinterpret_cast<const char*>(frame.pose->matrix().data()), 16 * sizeof(double));
  return key + '\n';
}

}  // namespace

/// Whether an arc ends without a condition, switches nothing on its way, moves no other axes, and
/// turns the tool in the usual way.
bool Pdl2Run::is_plain_arc(const ArcText& arc) {
  const std::string& file = text_.files.at(reader().place().file).text;
  const std::string statement =
      lower_case(file.substr(arc.statement.begin, arc.statement.end - arc.statement.begin));
  for (const char* word : {"til", "condition", "xtndpos", "syncmove"})
    if (statement.find(word) != std::string::npos) return false;
  if (!arcs_are_plain_) arcs_are_plain_ = !mentions(text_.files, {"$ornt_type", "xtndpos"});
  return *arcs_are_plain_;
}

/// Reads from after MOVE or MOVEFLY.
void Pdl2Run::move(bool flies) {
  const Place place = reader().place();
  ArcText arc;
  arc.statement.begin = reader().end_of_last() - std::string(flies ? "movefly" : "move").size();
  if (reader().accept("arm")) read_pdl2_variable(reader());
  const Pdl2Settings before = settings_;
  arc.word.begin = reader().offset();
  const MotionKind how = kind();
  arc.word.end = std::max(arc.word.begin, reader().end_of_last());
  if (!reader().accept("to"))
    reader().fail("a motion relative to where the robot is, or along a path of nodes",
                  "give a program of MOVE .. TO");
  arc.target.begin = reader().offset();
  const Target end = target();
  arc.target.end = arc.via.begin = reader().end_of_last();
  std::optional<Target> via;
  if (reader().accept("via")) via = target();
  arc.via.end = reader().end_of_last();
  if ((how == MotionKind::kCircular) != via.has_value() || (via && !via->pose))
    reader().fail("an arc without a pose VIA, or VIA without an arc", "give CIRCULAR TO .. VIA ..");
  clauses();
  arc.statement.end = reader().end_of_last();
  add(how, via, end, flies, place);
  if (via && end.pose && is_plain_arc(arc)) text_.steps.back().arc = arc;
  settings_ = before;
}

MotionKind Pdl2Run::kind() {
  std::string word = settings_.move_type;
  for (const char* name : {"linear", "circular", "joint"})
    if (reader().at_name(name)) word = lower_case(reader().next().text);
  if (word == "linear") return MotionKind::kLinear;
  if (word == "circular") return MotionKind::kCircular;
  if (word == "joint") return MotionKind::kJoint;
  reader().fail("$MOVE_TYPE is not known here: " + scan_cell_common::excerpt(word),
                "say LINEAR, CIRCULAR or JOINT in the move");
}

Pdl2Run::Target Pdl2Run::target() {
  if (reader().at_symbol('{') || reader().at_name("pos") || reader().at_name("xtndpos")) {
    const Pdl2Value value = read_pdl2_value(reader());
    if (!value.pose && !value.joints)
      throw UnusableInput(to_string(value.place, text_.files), "a pose that is computed",
                          kGiveLiteral);
    if (reader().at_symbol(':')) reader().fail("a pose that is computed with ':'", kGiveLiteral);
    return {value.pose, value.joints.value_or(std::vector<double>{})};
  }
  return named_target();
}

Pdl2Run::Target Pdl2Run::named_target() {
  const std::string where = reader().where();
  const std::string written(reader().peek().text);
  const std::string name = read_pdl2_variable(reader());
  if (reader().at_symbol(':') || reader().at_symbol('(') || reader().at_symbol('.'))
    throw UnusableInput(where, "a pose that is computed: " + written, kGiveLiteral);
  const Pdl2Value* value = name.empty() ? nullptr : variables_.find(name);
  if (value && value->pose) return {value->pose, {}};
  if (value && value->joints) return {{}, *value->joints};
  if (!value && variables_.type(name) == "jointpos") return {};
  throw UnusableInput(where,
                      "the pose " + written +
                          (value ? " is computed in line " + std::to_string(value->place.line)
                                 : " is not in the files"),
                      value ? kGiveLiteral : "give the variables of its program as text (.lsv)");
}

/// ADVANCE, TIL, WITH; after a comma they may go on in the next line, up to ENDMOVE.
void Pdl2Run::clauses() {
  while (!at_statement_end(reader())) {
    if (reader().at_name("syncmove"))
      reader().fail("SYNCMOVE: another arm moves, too", "give a program for one arm");
    if (reader().accept("with")) {
      with();
    } else if (reader().accept(',')) {
      if (reader().peek().kind == TokenKind::kLineEnd) reader().next();
    } else {
      reader().next();
    }
  }
}

/// WITH $LIN_SPD = 0.05, $FLY_DIST = 2, CONDITION[1]
void Pdl2Run::with() {
  do {
    if (reader().peek().kind == TokenKind::kLineEnd) reader().next();
    if (reader().peek().kind != TokenKind::kName || reader().at_name("endmove") ||
        reader().at_name("with"))
      return;
    const std::string variable = read_pdl2_variable(reader());
    if (!reader().accept('=')) continue;
    if (!set(settings_, variable, reader(), variables_))
      while (!at_statement_end(reader()) && !reader().at_symbol(',') && !reader().at_name("with"))
        if (reader().next().text == "(") skip_parentheses(reader());
  } while (reader().accept(','));
}

void Pdl2Run::add(MotionKind kind, const std::optional<Target>& via, const Target& to, bool flies,
                  const Place& place) {
  StepText step{place, {}, {}};
  if (!to.pose) {
    text_.program.steps.emplace_back(JointMove{to.joints});
    text_.steps.push_back(step);
    return;
  }
  Move move;
  move.kind = kind;
  move.frames = frames_index();
  if (via) {
    step.via = pose_text(*via->pose);
    move.via = text_.poses[*step.via].pose;
  }
  step.pose = pose_text(*to.pose);
  move.pose = text_.poses[*step.pose].pose;
  const double share = settings_.program_override * settings_.arm_override;
  if (settings_.speed) move.speed = *settings_.speed * share;
  move.joint_speed = share;
  move.zone = flies ? settings_.fly_distance : 0;
  text_.program.steps.emplace_back(move);
  text_.steps.push_back(step);
}

std::size_t Pdl2Run::pose_text(const Pdl2Pose& literal) {
  const Eigen::Isometry3d pose = pdl2_pose(literal.values());
  if (!pose.matrix().allFinite())
    throw UnusableInput(to_string(literal.place, text_.files), "a pose beyond all limits",
                        "correct it");
  const auto [known, is_new] =
      poses_.insert({{literal.place.file, literal.offset}, text_.poses.size()});
  if (is_new) text_.poses.push_back({pose, literal.place, literal.offset});
  return known->second;
}

std::size_t Pdl2Run::frames_index() {
  const Frames frames = settings_.frames();
  const auto [known, is_new] =
      frames_.insert({key_of(frames.tool) + key_of(frames.user), text_.program.frames.size()});
  if (is_new) text_.program.frames.push_back(frames);
  return known->second;
}

}  // namespace tool_path_programs
