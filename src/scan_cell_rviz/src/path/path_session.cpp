// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/path_session.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_rviz {

using tool_paths::PathEdit;
using tool_paths::WaypointRange;

void PathSession::open(const tool_paths::ToolPath& path, const std::vector<double>& expected,
                       const std::string& frame) {
  path_ = path;
  expected_ = expected;
  frame_ = frame;
  drop_all();
  select(std::nullopt);
}

void PathSession::close() {
  open({}, {}, "");
}

/// Applies the active edits again.
/// @return whether this is possible; if not, the view stays as it was
bool PathSession::show() {
  try {
    edited_ = path_.segments.empty() ? tool_paths::EditedPath() : tool_paths::edited(path_, edits_);
  } catch (const scan_cell_common::Error& error) {
    Q_EMIT failed(QString::fromStdString(error.what()));
    return false;
  }
  waypoints_.clear();
  segments_.clear();
  for (std::size_t s = 0; s < edited_.path.segments.size(); ++s)
    for (const tool_paths::Waypoint& waypoint : edited_.path.segments[s].waypoints) {
      waypoints_.push_back(waypoint);
      segments_.push_back(s);
    }
  if (selected_ && selected_->last >= waypoints_.size()) selected_.reset();
  Q_EMIT changed();
  return true;
}

void PathSession::add(const PathEdit& edit) {
  add(std::vector<PathEdit>{edit});
}

void PathSession::add(const std::vector<PathEdit>& edits) {
  edits_.insert(edits_.end(), edits.begin(), edits.end());
  if (show())
    undone_.clear();
  else
    edits_.resize(edits_.size() - edits.size());
}

void PathSession::undo() {
  if (edits_.empty()) return;
  undone_.push_back(edits_.back());
  edits_.pop_back();
  show();
}

void PathSession::redo() {
  if (undone_.empty()) return;
  edits_.push_back(undone_.back());
  undone_.pop_back();
  show();
}

void PathSession::drop_all() {
  edits_.clear();
  undone_.clear();
  show();
}

void PathSession::select(const std::optional<WaypointRange>& waypoints) {
  selected_ = waypoints && waypoints->last < waypoints_.size() ? waypoints : std::nullopt;
  Q_EMIT selectionChanged();
}

std::vector<std::size_t> PathSession::deleted() const {
  std::set<std::size_t> left;
  for (const tool_paths::WaypointOrigin& origin : edited_.origins)
    if (!origin.added) left.insert(origin.first);
  std::vector<std::size_t> gone;
  for (std::size_t i = 0; i < waypoint_count(path_); ++i)
    if (left.count(i) == 0) gone.push_back(i);
  return gone;
}

QString PathSession::segment_of(std::size_t waypoint) const {
  const std::size_t segment = segments_.at(waypoint);
  const std::string& name = edited_.path.segments.at(segment).name;
  return name.empty() ? QString::number(segment) : QString::fromStdString(name);
}

double PathSession::expected_of(std::size_t waypoint) const {
  const tool_paths::WaypointOrigin& origin = edited_.origins.at(waypoint);
  if (std::max(origin.first, origin.second) >= expected_.size())
    return std::numeric_limits<double>::quiet_NaN();
  const double one = expected_[origin.first], other = expected_[origin.second];
  return std::isnan(one) || std::isnan(other) ? std::nan("") : std::max(one, other);
}

QStringList PathSession::words() const {
  QStringList words;
  for (const PathEdit& edit : edits_)
    words.append(QString::fromStdString(to_string(edit)));
  return words;
}

QString PathSession::yaml() const {
  return QString::fromStdString(tool_paths::to_yaml(edits_));
}

PathSession& shared_path_session() {
  static PathSession session;
  return session;
}

}  // namespace scan_cell_rviz
