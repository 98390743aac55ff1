// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rviz/tool.h>

namespace scan_cell_rviz {

/// Picks places on the reference, for a path through them. The other buttons, and the left button
/// off the reference, move the view as usual.
class PickTool : public rviz::Tool {
  Q_OBJECT

 public:
  PickTool() { shortcut_key_ = 'k'; }

  void activate() override;
  void deactivate() override {}
  int processMouseEvent(rviz::ViewportMouseEvent& event) override;

 private:
  bool pick(rviz::ViewportMouseEvent& event);

  bool missed_ = false;  // by the last click
};

}  // namespace scan_cell_rviz
