// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/scan/edit_tool.h"

#include <OgreSceneNode.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/viewport_mouse_event.h>

#include <QKeyEvent>

#include "scan_cell_common/errors/errors.h"
#include "view/cloud_frame.h"
#include "view/mouse_ray.h"

namespace scan_cell_rviz {

using Eigen::Vector3d;

void EditTool::onInitialize() {
  line_ = std::make_unique<rviz::BillboardLine>(scene_manager_);
  constexpr float kWidth = 0.001F;  // [m] chosen
  line_->setLineWidth(kWidth);
  line_->setColor(0.9F, 0.1F, 0.1F, 1);
}

void EditTool::activate() {
  begin_anew();
  setStatus(help());
}

void EditTool::deactivate() {
  begin_anew();
  draw({}, false);
}

/// Reports a failure on the page, and starts over.
template <class Act>
void EditTool::attempt(const Act& act) {
  try {
    act();
  } catch (const scan_cell_common::Error& error) {
    begin_anew();
    Q_EMIT shared_edit_session().failed(QString::fromStdString(error.what()));
  }
}

int EditTool::processMouseEvent(rviz::ViewportMouseEvent& event) {
  const bool by_left = event.left() || event.leftUp();
  if (!by_left || event.alt()) {
    context_->getViewManager()->getCurrent()->handleMouseEvent(event);
    setStatus(help());  // replaces the view's help for the left button
    return Render;
  }
  attempt([&] {
    if (event.type == QEvent::MouseButtonDblClick) {
      finish();
    } else if (event.leftUp()) {
      release();
    } else if (const auto ray = ray_of(event)) {
      if (event.leftDown()) press(*ray);
      if (event.type == QEvent::MouseMove) drag(*ray);
    }
  });
  return Render;
}

int EditTool::processKeyEvent(QKeyEvent* event, rviz::RenderPanel* panel) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    attempt([this] { finish(); });
    return Render;
  }
  if (event->key() != Qt::Key_Escape) return rviz::Tool::processKeyEvent(event, panel);
  begin_anew();
  draw({}, false);
  return Render;
}

/// The ray in the cloud's frame; none: there is no cloud, or rviz does not know its frame.
std::optional<Ray> EditTool::ray_of(const rviz::ViewportMouseEvent& event) {
  const EditedViewPtr view = shared_edit_session().view();
  const auto frame = view ? frame_in_view(*context_, view->frame) : std::nullopt;
  if (!frame) {
    setStatus(view ? tr("The frame of the scan is not known to rviz.")
                   : tr("No scan is in view: scan a part, or choose a run."));
    return std::nullopt;
  }
  return ray_under(event, *frame);
}

void EditTool::draw(const std::vector<Vector3d>& places, bool closed) {
  line_->clear();
  const EditedViewPtr view = shared_edit_session().view();
  if (places.empty() || !view) return;
  if (const auto frame = frame_in_view(*context_, view->frame)) {
    line_->setPosition(frame->position);
    line_->setOrientation(frame->orientation);
  }
  line_->setMaxPointsPerLine(static_cast<std::uint32_t>(places.size()) + 1);
  for (const Vector3d& place : places)
    line_->addPoint(to_ogre(place));
  if (closed) line_->addPoint(to_ogre(places.front()));
}

void EditTool::edit(const EditShape& shape) {
  shared_edit_session().apply(shape);
  begin_anew();
  draw({}, false);
}

}  // namespace scan_cell_rviz
