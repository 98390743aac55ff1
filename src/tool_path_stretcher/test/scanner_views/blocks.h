// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include "scanner_views/parts/terrace.h"
#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"

namespace scanner_views {

inline Mesh block(double width, double depth, double height) {
  return solid_of(Terrace{cases::rectangle_loop(width, depth), height});
}

/// A block of 100 x 100 x 10 mm with one of 40 x 60 x 30 mm on it.
inline Mesh step() {
  return solid_of(
      Terrace{cases::rectangle_loop(0.1, 0.1), 0.01, {{cases::rectangle_loop(0.04, 0.06), 0.04}}});
}

/// The same surface with every `each`-th triangle flipped.
inline Mesh wound_otherwise(Mesh mesh, std::size_t each = 1) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += each)
    std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
  return mesh;
}

inline tool_path_stretcher::Surface surface_of(const Mesh& mesh) {
  return tool_path_stretcher::surface_from_mesh(
      to_polygon_mesh(mesh), tool_path_stretcher::StretchParameters().leaf, "mesh");
}

}  // namespace scanner_views
