// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "path/path_session.h"
#include "view/handle_server.h"

namespace scan_cell_rviz {

/// Arrows and rings at the last of the chosen waypoints: when the mouse button is released, its
/// change is applied to all of them. An interactive marker on the topic ~waypoint of this node.
class WaypointHandles : public QObject {
  Q_OBJECT

 public:
  explicit WaypointHandles(PathSession& session);

  /// Shows them from now on whenever a waypoint is chosen.
  void show();
  const std::string& topic() const { return server_.topic(); }  //!< of the interactive markers

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedbackConstPtr;

  void draw();
  void on_feedback(const Feedback& feedback);
  void take(const Feedback& feedback);

  PathSession& session_;
  bool shown_ = false;
  HandleServer server_;
};

}  // namespace scan_cell_rviz
