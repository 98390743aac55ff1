// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/display.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>

#include <QTest>
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
