// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "link/cell_link.h"
#include "link/design_link.h"
#include "link/pass_link.h"
#include "link/teach_link.h"

namespace scan_cell_rviz {

/// All that a seat knows of the cell.
struct SeatLinks {
  explicit SeatLinks(const NodeNames& names)
      : cell(names), teach(names), design(names), passes(names) {}

  /// From here on signals come: connect them before.
  void start() {
    cell.start();
    teach.start();
    design.start();
  }

  CellLink cell;
  TeachLink teach;
  DesignLink design;
  PassLink passes;
};

}  // namespace scan_cell_rviz
