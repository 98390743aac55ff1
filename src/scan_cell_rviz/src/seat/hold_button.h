// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>

namespace scan_cell_rviz {

/// Held to run, by the mouse or by the space bar. It is let go, too, where it loses the focus, is
/// hidden or disabled, or its window is no longer the active one.
class HoldButton : public QPushButton {
  Q_OBJECT

 public:
  HoldButton(const char* name, const QString& text, QWidget* parent);

  bool is_held() const { return held_; }

  /// As if the person had: it must be pressed anew.
  void let_go();

 Q_SIGNALS:
  void heldChanged(bool held);

 protected:
  bool event(QEvent* event) override;

 private:
  void set_held(bool held);

  bool held_ = false;
};

}  // namespace scan_cell_rviz
