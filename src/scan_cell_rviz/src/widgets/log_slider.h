// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>
#include <QSlider>
#include <QWidget>

namespace scan_cell_rviz {

/// Input of a positive number: a slider two decades to either side of the initial value, and a box
/// for any allowed number.
class LogSlider : public QWidget {
  Q_OBJECT

 public:
  /// @param value initial, above 0
  /// @param decimals shown in the box
  LogSlider(double value, double min, double max, int decimals, QWidget* parent = nullptr);

  double value() const { return box_->value(); }
  void set_value(double value) { box_->setValue(value); }
  QDoubleSpinBox* box() const { return box_; }
  QSlider* slider() const { return slider_; }

 Q_SIGNALS:
  void changed();

 private:
  void show_on_slider(double value);

  QSlider* slider_;
  QDoubleSpinBox* box_;
  double least_;  // of the slider
  double most_;
};

}  // namespace scan_cell_rviz
