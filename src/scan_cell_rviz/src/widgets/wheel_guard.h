// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>
#include <QWidget>

namespace scan_cell_rviz {

/// Who scrolls over a page must not change a value that happens to pass under the pointer: the
/// wheel turns only what a person has chosen.
class WheelGuard : public QObject {
 public:
  /// Of what is on the page now.
  explicit WheelGuard(QWidget* page) : QObject(page) {
    for (QWidget* const widget : page->findChildren<QWidget*>()) {
      const bool turns = qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
                         qobject_cast<QComboBox*>(widget) != nullptr ||
                         qobject_cast<QSlider*>(widget) != nullptr;
      if (!turns) continue;
      widget->setFocusPolicy(Qt::StrongFocus);
      widget->installEventFilter(this);
    }
  }

  bool eventFilter(QObject* object, QEvent* event) override {
    const bool turns =
        event->type() == QEvent::Wheel && !qobject_cast<QWidget*>(object)->hasFocus();
    if (turns) event->ignore();  // the page scrolls
    return turns;
  }
};

}  // namespace scan_cell_rviz
