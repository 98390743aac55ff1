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

/// An adapted path that a person edits, with undo and redo without end. The path itself never
/// changes: what the person sees is what the edits in force make of it.
class PathSession : public QObject {
  Q_OBJECT

 public:
  /// Another path, without edits.
  /// @param path [m]; without segments: there is none
  /// @param expected [m] of each waypoint; NaN: not known
  void open(const tool_paths::ToolPath& path, const std::vector<double>& expected,
            const std::string& frame);
  void close();  ///< there is no path

  /// Done, or told by failed() why not; then nothing has changed.
  void add(const tool_paths::PathEdit& edit);
  void add(const std::vector<tool_paths::PathEdit>& edits);  ///< all of them or none
  void undo();
  void redo();
  void drop_all();
  void select(const std::optional<tool_paths::WaypointRange>& waypoints);

  bool is_open() const { return !edited_.origins.empty(); }
  const tool_paths::EditedPath& edited() const { return edited_; }
  const std::vector<tool_paths::Waypoint>& waypoints() const { return waypoints_; }
  std::vector<std::size_t> deleted() const;  ///< waypoints of the path before, in their order
  tool_paths::Points positions_before() const { return positions_of(path_); }  ///< [m]
  QString segment_of(std::size_t waypoint) const;
  double expected_of(std::size_t waypoint) const;  ///< [m]; NaN: not known
  const std::optional<tool_paths::WaypointRange>& selected() const { return selected_; }
  const std::string& frame() const { return frame_; }
  const std::vector<tool_paths::PathEdit>& edits() const { return edits_; }  ///< in force
  QStringList words() const;                                                 ///< the same
  QString yaml() const;  ///< the same as files have them
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
  std::vector<tool_paths::PathEdit> undone_;  // the next one to redo last
  tool_paths::EditedPath edited_;
  std::vector<tool_paths::Waypoint> waypoints_;  // of all segments
  std::vector<std::size_t> segments_;            // of each waypoint
  std::optional<tool_paths::WaypointRange> selected_;
};

/// The one that the seat and the displays and tools of rviz share.
PathSession& shared_path_session();

}  // namespace scan_cell_rviz
