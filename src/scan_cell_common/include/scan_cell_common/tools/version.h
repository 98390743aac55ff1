// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace scan_cell_common {

/// The suite's version, from package.xml: "0.1.0".
const char* suite_version();

}  // namespace scan_cell_common
