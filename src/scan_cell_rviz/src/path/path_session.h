// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "tool_paths/path_edits.h"

namespace scan_cell_rviz {

/// An adapted path edited by a person, with unlimited undo and redo. The path itself never changes:
/// the person sees it with the active edits applied.
class PathSession : public QObject {
  Q_OBJECT

 public:
  /// Opens another path, without edits.
  /// @param path [m]; without segments: no path
  /// @param expected [m] of each waypoint; NaN: not known
  void open(const tool_paths::ToolPath& path, const std::vector<double>& expected,
            const std::string& frame);
  void close();  ///< removes the path

  /// Adds an edit. If it fails, failed() tells why and nothing changes.
  void add(const tool_paths::PathEdit& edit);
  void add(const std::vector<tool_paths::PathEdit>& edits);  ///< all or none
  void undo();
  void redo();
  void drop_all();
  void select(const std::optional<tool_paths::WaypointRange>& waypoints);

  bool is_open() const { return !edited_.origins.empty(); }
  const tool_paths::EditedPath& edited() const { return edited_; }
  const std::vector<tool_paths::Waypoint>& waypoints() const { return waypoints_; }
  std::vector<std::size_t> deleted() const;  ///< waypoints of the unedited path, in order
  tool_paths::Points positions_before() const { return positions_of(path_); }  ///< [m]
  QString segment_of(std::size_t waypoint) const;
  double expected_of(std::size_t waypoint) const;  ///< [m]; NaN: not known
  const std::optional<tool_paths::WaypointRange>& selected() const { return selected_; }
  const std::string& frame() const { return frame_; }
  const std::vector<tool_paths::PathEdit>& edits() const { return edits_; }  ///< active ones
  QStringList words() const;                                                 ///< the same
  QString yaml() const;  ///< the same as in files
  bool can_undo() const { return !edits_.empty(); }
  bool can_redo() const { return !undone_.empty(); }

 Q_SIGNALS:
  void changed();
  void selectionChanged();
  void failed(QString message);

 private:
  bool show();

  tool_paths::ToolPath path_;
  std::vector<double> expected_;
  std::string frame_;
  std::vector<tool_paths::PathEdit> edits_;
  std::vector<tool_paths::PathEdit> undone_;  // the last is redone first
  tool_paths::EditedPath edited_;
  std::vector<tool_paths::Waypoint> waypoints_;  // of all segments
  std::vector<std::size_t> segments_;            // of each waypoint
  std::optional<tool_paths::WaypointRange> selected_;
};

/// The session that the seat and rviz's displays and tools share.
PathSession& shared_path_session();

}  // namespace scan_cell_rviz
