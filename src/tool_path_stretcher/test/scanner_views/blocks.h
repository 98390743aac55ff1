// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scanner_views/parts/terrace.h"

namespace scanner_views {

inline Mesh block(double width, double depth, double height) {
  return solid_of(Terrace{cases::rectangle_loop(width, depth), height});
}

/// A block of 100 x 100 x 10 mm that carries one of 40 x 60 x 30 mm.
inline Mesh step() {
  return solid_of(
      Terrace{cases::rectangle_loop(0.1, 0.1), 0.01, {{cases::rectangle_loop(0.04, 0.06), 0.04}}});
}

}  // namespace scanner_views
