// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreCamera.h>
#include <OgreViewport.h>
#include <rviz/display.h>
#include <rviz/render_panel.h>
#include <rviz/tool.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/viewport_mouse_event.h>
#include <rviz/visualization_manager.h>

#include <QTest>
#include <cmath>
#include <functional>
#include <memory>

#include "view/cloud_frame.h"

namespace scan_cell_rviz {

constexpr int kPatience = 20000;  // [ms] software rendering

/// Serves the view until it is so.
inline bool comes(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, kPatience);
}

/// rviz without its window: a view of the world from above. There is one a process.
struct RvizView {
  RvizView() {
    panel.initialize(manager.getSceneManager(), &manager);
    panel.resize(800, 600);
    panel.show();
    manager.initialize();
    manager.setFixedFrame("world");
    manager.getViewManager()->setCurrentViewControllerType("rviz/TopDownOrtho");
  }

  /// @return whether it knows the world
  bool start() {
    manager.startUpdate();
    return comes([this] { return frame_in_view(manager, "world").has_value(); });
  }

  /// Gives a tool an event of the left button over a place of the world.
  void mouse(rviz::Tool* tool, QEvent::Type type, const Eigen::Vector3d& place,
             Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    Ogre::Viewport* const viewport = panel.getViewport();
    const Ogre::Camera* const camera = viewport->getCamera();
    const Ogre::Vector3 seen =
        camera->getProjectionMatrix() * (camera->getViewMatrix() * to_ogre(place));
    rviz::ViewportMouseEvent event;
    event.panel = &panel;
    event.viewport = viewport;
    event.type = type;
    event.x = static_cast<int>(
        std::lround((seen.x + 1) / 2 * static_cast<float>(viewport->getActualWidth())));
    event.y = static_cast<int>(
        std::lround((1 - seen.y) / 2 * static_cast<float>(viewport->getActualHeight())));
    event.last_x = event.x;
    event.last_y = event.y;
    event.wheel_delta = 0;
    event.acting_button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    event.buttons_down =
        type == QEvent::MouseButtonRelease ? Qt::MouseButtons(Qt::NoButton) : Qt::LeftButton;
    event.modifiers = modifiers;
    tool->processMouseEvent(event);
  }

  rviz::RenderPanel panel;
  rviz::VisualizationManager manager{&panel};
};

/// What a display says of something, such as "Way"; empty: nothing.
inline QString status_of(const rviz::Display& display, const QString& of) {
  for (int i = 0; i < display.numChildren(); ++i) {
    rviz::Property* const status = display.childAt(i);  // its name tells the level, too
    if (!status->getName().startsWith("Status")) continue;
    for (int k = 0; k < status->numChildren(); ++k)
      if (status->childAt(k)->getName() == of) return status->childAt(k)->getValue().toString();
  }
  return {};
}

}  // namespace scan_cell_rviz
