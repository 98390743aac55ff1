// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/hold_button.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>

namespace scan_cell_rviz {

HoldButton::HoldButton(const char* name, const QString& text, QWidget* parent)
    : QPushButton(text, parent) {
  setObjectName(name);
  setFocusPolicy(Qt::StrongFocus);
  setAutoDefault(false);
  connect(this, &QPushButton::pressed, this, [this] {
    if (pressing_) set_held(true);
  });
  connect(this, &QPushButton::released, this, [this] { set_held(false); });
}

void HoldButton::let_go() {
  setDown(false);
  set_held(false);
}

bool HoldButton::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::WindowDeactivate:
      let_go();
      break;
    case QEvent::EnabledChange:
      if (!isEnabled()) let_go();
      break;
    default:
      break;
  }
  return QPushButton::event(event);
}

void HoldButton::mousePressEvent(QMouseEvent* event) {
  pressing_ = true;
  QPushButton::mousePressEvent(event);
  pressing_ = false;
}

/// Qt would press the button again when the pointer comes back.
void HoldButton::mouseMoveEvent(QMouseEvent* event) {
  if (held_) QPushButton::mouseMoveEvent(event);
}

void HoldButton::keyPressEvent(QKeyEvent* event) {
  pressing_ = !event->isAutoRepeat();
  QPushButton::keyPressEvent(event);
  pressing_ = false;
}

void HoldButton::set_held(bool held) {
  if (held == held_) return;
  held_ = held;
  Q_EMIT heldChanged(held);
}

}  // namespace scan_cell_rviz
