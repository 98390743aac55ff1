// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/describe.h"

#include <sstream>

namespace cloud_preprocess {

void RangeCheck::read(const std::string& name, double value, const Range& range) {
  if (value >= range.least && value <= range.most) return;  // not so for NaN
  std::ostringstream given, cure;
  given << value;
  cure << "give a value from " << range.least << " to " << range.most;
  throw scan_cell_common::InvalidParameter(name, given.str(), cure.str());
}

void RangeCheck::read(const std::string& name, int value, const Range& range) {
  read(name, static_cast<double>(value), range);
}

void RangeCheck::read(const std::string& name, const std::vector<double>& value,
                      const Range& range) {
  for (const double element : value)
    read(name, element, range);
}

}  // namespace cloud_preprocess
