// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>

namespace scan_cell_rviz {

/// A button that acts while it is held, by the mouse or by the space bar. It is also released when
/// the pointer leaves it, it loses the focus, is hidden or disabled, or its window becomes
/// inactive. It must then be pressed again: moving the pointer back is not enough.
class HoldButton : public QPushButton {
  Q_OBJECT

 public:
  HoldButton(const char* name, const QString& text, QWidget* parent);

  bool is_held() const { return held_; }

  /// Releases the button: it must be pressed again.
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
  bool pressing_ = false;  // within a press event of a key or the mouse
};

}  // namespace scan_cell_rviz
