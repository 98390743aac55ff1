// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>

namespace scan_cell_rviz {

/// Held to run, by the mouse or by the space bar. It is let go, too, where the pointer leaves it,
/// it loses the focus, is hidden or disabled, or its window is no longer the active one. Whatever
/// let it go, it must be pressed anew: to move the pointer back does not do it.
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
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void set_held(bool held);

  bool held_ = false;
  bool pressing_ = false;  // a key or the mouse's button goes down now
};

}  // namespace scan_cell_rviz
