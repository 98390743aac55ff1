// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/log_slider.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace scan_cell_rviz {
namespace {

constexpr int kSteps = 400;    // of the slider: at most 2.3 % each; chosen
constexpr double kSpan = 100;  // factor to either side; chosen

}  // namespace

LogSlider::LogSlider(double value, double min, double max, int decimals, QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      box_(new QDoubleSpinBox(this)),
      least_(std::max({min, value / kSpan, std::pow(10, -decimals)})),
      most_(std::min(max, value * kSpan)) {
  box_->setDecimals(decimals);
  box_->setRange(min, max);
  box_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box_->setValue(value);
  slider_->setRange(0, kSteps);
  show_on_slider(value);
  auto* const layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(slider_, 1);
  layout->addWidget(box_);
  connect(slider_, &QSlider::valueChanged, this, [this](int step) {
    const QSignalBlocker quiet(slider_);  // it stays under the mouse
    box_->setValue(least_ * std::pow(most_ / least_, static_cast<double>(step) / kSteps));
  });
  connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double now) {
    if (!slider_->signalsBlocked()) show_on_slider(now);
    Q_EMIT changed();
  });
}

void LogSlider::show_on_slider(double value) {
  const QSignalBlocker quiet(slider_);
  const double share =
      std::log(std::clamp(value, least_, most_) / least_) / std::log(most_ / least_);
  slider_->setValue(static_cast<int>(std::lround(share * kSteps)));
}

}  // namespace scan_cell_rviz
