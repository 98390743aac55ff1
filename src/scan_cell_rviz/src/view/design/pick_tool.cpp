// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/design/pick_tool.h"

#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/viewport_mouse_event.h>

#include <pluginlib/class_list_macros.hpp>

#include "design/pick_session.h"
#include "view/mouse_ray.h"

namespace scan_cell_rviz {

void PickTool::activate() {
  setStatus(shared_pick_session().is_open()
                ? tr("Click places on the reference, in the order of the path.")
                : tr("No reference is in view: choose a recipe on the page of new paths."));
}

/// @return whether the ray met the reference
bool PickTool::pick(rviz::ViewportMouseEvent& event) {
  PickSession& session = shared_pick_session();
  const auto frame = frame_in_view(*context_, session.frame());
  return session.is_open() && frame && session.pick(ray_under(event, *frame));
}

int PickTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const bool is_click = event.leftDown() && !event.alt();
  if (is_click) missed_ = !pick(event);
  if (!is_click || missed_) context_->getViewManager()->getCurrent()->handleMouseEvent(event);
  activate();  // replaces the view's help for the left button
  if (missed_) setStatus(tr("Nothing of the reference was there. Click on it."));
  return Render;
}

}  // namespace scan_cell_rviz

PLUGINLIB_EXPORT_CLASS(scan_cell_rviz::PickTool, rviz::Tool)
