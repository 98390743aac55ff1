// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "seat/band.h"

#include <QGridLayout>

#include "widgets/labels_and_buttons.h"

namespace scan_cell_rviz {
namespace {

struct Look {
  const char* mark;
  const char* style;
};

/// Dark on light in both themes: the band has its own background.
Look look_of(Level level) {
  switch (level) {
    case Level::kGood:
      return {"\u25cf", "background: #d8ead8; color: #10280f;"};
    case Level::kNotice:
      return {"\u25b2", "background: #fbe7b2; color: #3a2a00;"};
    case Level::kBad:
      return {"\u2716", "background: #f6c9c4; color: #4a0b05; font-weight: bold;"};
    case Level::kLaser:
      return {"\u2600", "background: #ffd400; color: #000000; font-weight: bold;"};
    case Level::kGone:
      break;
  }
  return {"?", "background: #dcdcdc; color: #202020; font-style: italic;"};
}

}  // namespace

Band::Band(QWidget* parent) : QWidget(parent) {
  const std::array<std::pair<const char*, QString>, kDevices> devices = {
      {{"sign_robot", tr("Robot")},
       {"sign_camera", tr("Camera")},
       {"sign_laser", tr("Lasers")},
       {"sign_cell", tr("Cell")},
       {"sign_calibration", tr("Calibration")}}};
  auto* const layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  for (int i = 0; i < kDevices; ++i) {
    const auto& [name, title] = devices.at(static_cast<std::size_t>(i));
    layout->addWidget(new QLabel(title, this), i, 0);
    QLabel* const sign = text_label(name, this);
    sign->setMargin(3);
    sign->setAccessibleName(title);
    layout->addWidget(sign, i, 1);
    signs_.at(static_cast<std::size_t>(i)) = sign;
    show_sign(static_cast<Device>(i), {Level::kGone, "not heard of yet"});
  }
  layout->setColumnStretch(1, 1);
}

void Band::show_sign(Device device, const Sign& sign) {
  QLabel* const label = signs_.at(static_cast<std::size_t>(device));
  const Look look = look_of(sign.level);
  label->setText(QString::fromUtf8(look.mark) + " " + QString::fromStdString(sign.text));
  label->setStyleSheet(look.style);
}

}  // namespace scan_cell_rviz
