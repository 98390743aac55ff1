// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>

#include "widgets/wheel_guard.h"

namespace scan_cell_rviz {

/// A scroll area around a widget.
inline QScrollArea* scrolled(QWidget* inside, QWidget* parent) {
  auto* const area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  area->setWidget(inside);
  return area;
}

/// A scroll area around a page, for low screens; the widget with the focus is brought into view.
inline QScrollArea* scrolled_page(QWidget* page, QWidget* parent) {
  QScrollArea* const area = scrolled(page, parent);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumWidth(page->minimumSizeHint().width() +
                        area->verticalScrollBar()->sizeHint().width());
  new WheelGuard(page);
  QObject::connect(qApp, &QApplication::focusChanged, area, [=](QWidget*, QWidget* now) {
    if (now != nullptr && page->isAncestorOf(now)) area->ensureWidgetVisible(now);
  });
  return area;
}

/// A fixed number of lines: buttons must not move under the pointer when a message comes.
inline QScrollArea* in_lines(QLabel* label, int lines, QWidget* parent) {
  QScrollArea* const area = scrolled(label, parent);
  area->setFixedHeight(lines * label->fontMetrics().lineSpacing() + 2);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return area;
}

}  // namespace scan_cell_rviz
