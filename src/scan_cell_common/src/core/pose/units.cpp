// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/pose/units.h"

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

const std::vector<std::string>& length_units() {
  static const std::vector<std::string> units{"m", "mm", "inch"};
  return units;
}

double metres_per(const std::string& unit) {
  if (unit == "m") return 1;
  if (unit == "mm") return 1e-3;
  if (unit == "inch") return 0.0254;
  throw InvalidParameter("unit of length", "'" + unit + "'", "give m, mm or inch");
}

}  // namespace scan_cell_common
