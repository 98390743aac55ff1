// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "fanuc_reader/fanuc_flow.h"

#include <algorithm>

#include "fanuc_reader/fanuc_statements.h"
#include "scan_cell_common/errors/text.h"

namespace tool_path_programs {
namespace {

using Kind = FanucStatementKind;

constexpr const char* kOneOrder = "give the program that moves in one order, without conditions";

}  // namespace

FanucFlow::FanucFlow(const FanucSource& source, const std::set<std::string>& without_motion)
    : source_(source), without_motion_(without_motion) {}

bool FanucFlow::moves(const std::string& name, const TokenReader& where) {
  const FanucProgram* program = source_.program(name);
  if (!program) {
    if (without_motion_.count(scan_cell_common::lower_case(name)) != 0) return false;
    where.fail("a call of " + name + ", which is not in the given files",
               "give it, or name it as a program without motion");
  }
  const auto known = moves_.find(program);
  if (known != moves_.end()) return known->second;
  if (++depth_ > kDeepestFanucCall)
    where.fail("calls nested deeper than 50", "give a program with fewer of them");
  moves_[program] = false;  // meanwhile, so that circular calls end
  const bool found =
      std::any_of(program->statements.begin(), program->statements.end(),
                  [&](const FanucStatement& statement) { return moves(statement, *program); });
  --depth_;
  return moves_[program] = found;
}

bool FanucFlow::moves(const FanucStatement& statement, const FanucProgram& program) {
  if (statement.kind == Kind::kMotion || statement.kind == Kind::kFrame ||
      statement.kind == Kind::kChanged)
    return true;
  if (statement.kind != Kind::kCall && statement.kind != Kind::kBranch) return false;
  const TokenReader where = source_.reader(program.file, statement.begin);
  const FanucBranches branches = fanuc_branches(where, statement.end);
  if (branches.computed) where.fail("a jump or call that is computed at run time", kOneOrder);
  return std::any_of(branches.calls.begin(), branches.calls.end(),
                     [&](const std::string& name) { return moves(name, where); });
}

void FanucFlow::check(const FanucProgram& program) {
  std::map<int, std::size_t> labels;
  std::vector<std::size_t> moving = {0};  // number of moving statements before each
  int depth = 0;
  const auto& statements = program.statements;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const bool is_moving = moves(statements[i], program);
    const TokenReader where = source_.reader(program.file, statements[i].begin);
    if (is_moving && (depth > 0 || statements[i].kind == Kind::kBranch))
      where.fail("a motion, or a change of frames, under a condition or in a loop", kOneOrder);
    if (statements[i].kind == Kind::kBegin) ++depth;
    if (statements[i].kind == Kind::kEnd && depth-- == 0)
      where.fail("an end without a beginning", "correct the program");
    if (statements[i].kind == Kind::kLabel) labels[statements[i].label] = i;
    moving.push_back(moving.back() + (is_moving ? 1 : 0));
  }
  if (depth > 0)
    source_.reader(program.file, statements.back().begin)
        .fail("an IF or FOR without its end", "correct the program");
  for (std::size_t i = 0; i < statements.size(); ++i)
    if (statements[i].kind == Kind::kBranch) check_branch(program, i, labels, moving);
}

void FanucFlow::check_branch(const FanucProgram& program, std::size_t i,
                             const std::map<int, std::size_t>& labels,
                             const std::vector<std::size_t>& moving) {
  const FanucStatement& statement = program.statements[i];
  const TokenReader where = source_.reader(program.file, statement.begin);
  for (const int label : fanuc_branches(where, statement.end).labels) {
    const auto found = labels.find(label);
    if (found == labels.end())
      where.fail("a jump to label " + std::to_string(label) + ", which is not there",
                 "correct the program");
    const auto [first, last] = std::minmax(i, found->second);
    if (moving[last] != moving[first])
      where.fail("a jump over motions, or over changes of frames", kOneOrder);
  }
}

}  // namespace tool_path_programs
