// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QPushButton>

namespace scan_cell_rviz {

/// A label with as many lines as it needs. Names and notes are shown as plain text.
inline QLabel* text_label(const char* name, QWidget* parent) {
  auto* const label = new QLabel(parent);
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  return label;
}

inline QPushButton* named_button(const char* name, const QString& text, QWidget* parent) {
  auto* const button = new QPushButton(text, parent);
  button->setObjectName(name);
  return button;
}

}  // namespace scan_cell_rviz
