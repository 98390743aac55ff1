// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "surface/mesh_topology.h"

namespace tool_path_stretcher {

/// A side of a triangle.
struct Side {
  std::uint32_t low, high;  //!< vertices
  std::size_t triangle;
  bool forward;  //!< runs from the lower vertex to the higher one
};

/// The sides of all triangles, with those of one edge adjacent.
std::vector<Side> sides_of(const std::vector<Triangle>& triangles);

/// Calls `visit` with the first side of each edge and the one past its last.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const Side& each) {
      return each.low != first->low || each.high != first->high;
    });
    visit(first, last);
    first = last;
  }
}

}  // namespace tool_path_stretcher
