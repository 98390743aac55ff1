// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/path/waypoint_tool.h"

#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/viewport_mouse_event.h>

#include <algorithm>
#include <pluginlib/class_list_macros.hpp>

#include "path/path_session.h"
#include "view/mouse_ray.h"

namespace scan_cell_rviz {

void WaypointTool::activate() {
  setStatus(shared_path_session().is_open()
                ? tr("Click a waypoint, and with Shift another one for all between them.")
                : tr("No adapted path is in view: choose an accepted run."));
}

/// @return whether there was a waypoint
bool WaypointTool::choose(rviz::ViewportMouseEvent& event) {
  PathSession& session = shared_path_session();
  const auto frame = frame_in_view(*context_, session.frame());
  if (!session.is_open() || !frame) return false;
  const auto waypoint =
      meant(tool_paths::positions_of(session.edited().path), ray_under(event, *frame));
  if (!waypoint) return false;
  tool_paths::WaypointRange chosen{*waypoint, *waypoint};
  if (event.shift() && session.selected())
    chosen = {std::min(session.selected()->first, *waypoint),
              std::max(session.selected()->last, *waypoint)};
  session.select(chosen);
  return true;
}

int WaypointTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  if (!event.leftDown() || event.alt() || !choose(event))
    context_->getViewManager()->getCurrent()->handleMouseEvent(event);
  activate();  // replaces the view's help for the left button
  return Render;
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::WaypointTool, rviz::Tool)
