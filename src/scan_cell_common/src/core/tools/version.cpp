// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/tools/version.h"

namespace scan_cell_common {

const char* suite_version() {
  return SUITE_VERSION;
}

}  // namespace scan_cell_common
