// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "rewrite/path_frame.h"

#include "scan_cell_common/errors/errors.h"

namespace tool_path_programs {
namespace {

bool same(const std::optional<Eigen::Isometry3d>& one,
          const std::optional<Eigen::Isometry3d>& two) {
  return one.has_value() == two.has_value() && (!one || one->isApprox(*two, 1e-12));
}

}  // namespace

PathFrame::PathFrame(const ProgramText& text, bool in_base) : text_(text), in_base_(in_base) {
  const auto moves = moves_of(text.program);
  if (!moves.empty()) first_ = &text.program.frames.at(moves.front()->frames).user;
}

Eigen::Isometry3d PathFrame::operator()(std::size_t step) const {
  const Move& move = std::get<Move>(text_.program.steps[step]);
  const Frame& user = text_.program.frames[move.frames].user;
  if (in_base_) return place_of(user, step);
  if (user.name == first_->name && same(user.pose, first_->pose))
    return Eigen::Isometry3d::Identity();
  return place_of(*first_, step).inverse() * place_of(user, step);
}

const Eigen::Isometry3d& PathFrame::place_of(const Frame& user, std::size_t step) const {
  if (user.pose) return *user.pose;
  throw scan_cell_common::UnusableInput(to_string(text_.steps[step].place, text_.files),
                                        user.name.empty()
                                            ? "its user frame is not in the program"
                                            : "the program does not say where " + user.name + " is",
                                        "give the place of the frame");
}

}  // namespace tool_path_programs
