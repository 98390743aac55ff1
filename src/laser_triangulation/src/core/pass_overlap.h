// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "scan_cloud.h"

namespace laser_triangulation {

/// One laser's points of one pass.
struct Sweep {
  std::uint8_t pass = 0;   //!< from 0
  std::uint8_t laser = 0;  //!< its index
};

/// How far two sweeps lie apart where both saw the surface.
struct PassOverlap {
  Sweep one;
  Sweep other;
  std::size_t points = 0;  //!< of the other that were compared
  double median = 0;       //!< [m] distance along the surface's normal, without its sign
  double most = 0;         //!< [m] the same of 95 %
};

/// Compares each sweep with each other: points of one against the plane through their neighbours in
/// the other. Edges, and what only one of them saw, are passed over. Pairs that share too little
/// are left out.
std::vector<PassOverlap> compare_sweeps(const ScanCloud& cloud);

}  // namespace laser_triangulation
