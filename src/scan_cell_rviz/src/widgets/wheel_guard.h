// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractSpinBox>
#include <QChildEvent>
#include <QComboBox>
#include <QSlider>
#include <QWidget>

namespace scan_cell_rviz {

/// Scrolling a page must not change a value that passes under the pointer: the wheel changes only
/// the widget that has the focus.
class WheelGuard : public QObject {
 public:
  /// Guards all widgets on the page, also later ones.
  explicit WheelGuard(QWidget* page) : QObject(page) { guard(*page); }

  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() == QEvent::ChildPolished) {  // a newly added child is no spin box yet
      auto* const child = static_cast<QChildEvent*>(event)->child();
      if (child->isWidgetType()) guard(*static_cast<QWidget*>(child));
    }
    const auto* const widget = qobject_cast<QWidget*>(object);
    const bool turns = event->type() == QEvent::Wheel && widget != nullptr && is_turned(*widget) &&
                       !widget->hasFocus();
    if (turns) event->ignore();  // the page scrolls
    return turns;
  }

 private:
  static bool is_turned(const QWidget& widget) {
    return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           qobject_cast<const QSlider*>(&widget) != nullptr;
  }

  void guard(QWidget& widget) {
    if (is_turned(widget)) widget.setFocusPolicy(Qt::StrongFocus);
    widget.installEventFilter(this);  // once, even if called again
    for (QObject* const child : widget.children())
      if (child->isWidgetType()) guard(*static_cast<QWidget*>(child));
  }
};

}  // namespace scan_cell_rviz
