// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "link/cell_link.h"
#include "link/preparation/design_link.h"
#include "link/preparation/pass_link.h"
#include "link/preparation/teach_link.h"

namespace scan_cell_rviz {

/// All connections of a seat to the cell.
struct SeatLinks {
  explicit SeatLinks(const NodeNames& names)
      : cell(names), teach(names), design(names), passes(names) {}

  /// Starts sending signals: connect them before.
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
