// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QApplication>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>

#include "widgets/wheel_guard.h"

namespace scan_cell_rviz {

/// A widget of which as much is seen as there is room for.
inline QScrollArea* scrolled(QWidget* inside, QWidget* parent) {
  auto* const area = new QScrollArea(parent);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidgetResizable(true);
  area->setWidget(inside);
  return area;
}

/// A page of which a low screen shows a part; what gets the focus is brought into view.
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

/// Of so many lines at any time: buttons must not move under the pointer when a message comes.
inline QScrollArea* in_lines(QLabel* label, int lines, QWidget* parent) {
  QScrollArea* const area = scrolled(label, parent);
  area->setFixedHeight(lines * label->fontMetrics().lineSpacing() + 2);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  return area;
}

}  // namespace scan_cell_rviz
