// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

Error::Error(const std::string& thing, const std::string& value, const std::string& cure)
    : std::runtime_error(thing + ": " + value + "; " + cure),
      thing_(thing),
      value_(value),
      cure_(cure) {}

}  // namespace scan_cell_common
