// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>
#include <QWidget>
#include <array>

#include "signs/sign.h"

namespace scan_cell_rviz {

/// The states of the devices, always in view. Each sign has a mark and words, so that nobody has to
/// rely on colour.
class Band : public QWidget {
  Q_OBJECT

 public:
  explicit Band(QWidget* parent = nullptr);

  void show_sign(Device device, const Sign& sign);

 private:
  std::array<QLabel*, kDevices> signs_{};
};

}  // namespace scan_cell_rviz
