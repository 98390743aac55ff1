// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace scan_cell_rviz {

/// The pages of the seat, in order.
enum class Page { kPart, kClean, kFit, kPath, kWork, kHistory, kTeach, kDesign, kPasses };

}  // namespace scan_cell_rviz
