// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "passes/pass_session.h"

#include "scan_cell_common/ros/conversions.h"

namespace scan_cell_rviz {

using scan_cell_msgs::ScanPass;

QString pose_name(const ScanPass& pass, std::size_t pose) {
  if (pose == 0) return PassSession::tr("start");
  if (pose + 1 == pass.poses.size()) return PassSession::tr("end");
  return pass.kind == ScanPass::ARC ? PassSession::tr("via") : QString::number(pose + 1);
}

void PassSession::open(const std::string& frame, const Passes& passes) {
  frame_ = frame;
  before_.clear();
  undone_.clear();
  selected_.reset();
  show(passes);
  Q_EMIT selectionChanged();
}

void PassSession::show(const Passes& passes) {
  passes_ = passes;
  reach_.assign(passes.size(), {});
  Q_EMIT changed();
}

void PassSession::move(const PassPose& at, const Eigen::Isometry3d& pose) {
  Passes moved = passes_;
  moved.at(at.pass).poses.at(at.pose) = scan_cell_common::to_ros_pose(pose);
  before_.push_back(passes_);
  undone_.clear();
  show(moved);
}

void PassSession::undo() {
  if (before_.empty()) return;
  undone_.push_back(passes_);
  const Passes back = before_.back();
  before_.pop_back();
  show(back);
}

void PassSession::redo() {
  if (undone_.empty()) return;
  before_.push_back(passes_);
  const Passes again = undone_.back();
  undone_.pop_back();
  show(again);
}

void PassSession::select(const std::optional<PassPose>& at) {
  const bool is_there =
      at && at->pass < passes_.size() && at->pose < passes_[at->pass].poses.size();
  selected_ = is_there ? at : std::nullopt;
  Q_EMIT selectionChanged();
}

void PassSession::show_reach(const std::vector<PassReach>& reach) {
  if (reach.size() != passes_.size()) return;  // for a program that is no longer in view
  reach_ = reach;
  Q_EMIT reachChanged();
}

PassSession& shared_pass_session() {
  static PassSession session;
  return session;
}

}  // namespace scan_cell_rviz
