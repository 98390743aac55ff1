// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/hold_button.h"

#include <QEvent>

namespace scan_cell_rviz {

HoldButton::HoldButton(const char* name, const QString& text, QWidget* parent)
    : QPushButton(text, parent) {
  setObjectName(name);
  setFocusPolicy(Qt::StrongFocus);
  setAutoDefault(false);
  connect(this, &QPushButton::pressed, this, [this] { set_held(true); });
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

void HoldButton::set_held(bool held) {
  if (held == held_) return;
  held_ = held;
  Q_EMIT heldChanged(held);
}

}  // namespace scan_cell_rviz
