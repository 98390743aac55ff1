// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/tool.h>

namespace scan_cell_rviz {

/// Chooses a waypoint of the edited path by a click, and with Shift all up to another one. The
/// other buttons, and the left button off the path, move the view as usual.
class WaypointTool : public rviz::Tool {
  Q_OBJECT

 public:
  WaypointTool() { shortcut_key_ = 'w'; }

  void activate() override;
  void deactivate() override {}
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

 private:
  bool choose(rviz::ViewportMouseEvent& event);
};

}  // namespace scan_cell_rviz
