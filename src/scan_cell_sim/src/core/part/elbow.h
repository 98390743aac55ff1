// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part/tessellator.h"

namespace scan_cell_sim {

/// The elbow's wall and the discs that close its ends.
void add_elbow(const ElbowShape& elbow, Tessellator& tessellator);

}  // namespace scan_cell_sim
