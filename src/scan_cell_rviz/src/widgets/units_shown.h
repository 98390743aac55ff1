// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

#include "scan_cell_common/pose/units.h"

namespace scan_cell_rviz {

/// Factor that converts a number to mm or degrees for display.
/// @param unit as the parameter tables have it
inline double factor_of(const std::string& unit) {
  if (unit == "m") return scan_cell_common::kMillimetres;
  return unit == "rad" ? scan_cell_common::kDegrees : 1;
}

/// Displayed unit, with a leading space.
inline QString unit_shown(const std::string& unit) {
  if (unit == "m") return QCoreApplication::translate("UnitsShown", " mm");
  if (unit == "rad") return QCoreApplication::translate("UnitsShown", " deg");
  return unit.empty() ? QString() : " " + QString::fromStdString(unit);
}

}  // namespace scan_cell_rviz
