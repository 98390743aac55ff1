// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/reference/reference_surface.h"

#include <utility>

#include "deviation/reference/cloud_reference.h"
#include "deviation/reference/mesh_reference.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "tool_path_stretcher/surface.h"

namespace part_recipes {

std::string to_string(OutsideKnownBy outside) {
  switch (outside) {
    case OutsideKnownBy::kClosedMesh:
      return "closed mesh";
    case OutsideKnownBy::kViewpoints:
      return "viewpoints of the scan";
    case OutsideKnownBy::kUpwards:
      break;
  }
  return "+z of the reference";
}

ReferenceSurface::ReferenceSurface(Samples samples, OutsideKnownBy outside)
    : samples_(std::move(samples)), outside_(outside) {}

std::unique_ptr<ReferenceSurface> ReferenceSurface::load(const std::string& file,
                                                         double metres_per_unit) {
  constexpr double kLeaf = 0.001;  // [m] grid on which a cloud is reduced; chosen: half the
                                   // stretcher's, for the fits to be of smaller pieces
  const auto surface =
      tool_path_stretcher::load_surface(file, Eigen::Vector3d::Constant(kLeaf), metres_per_unit);
  if (!scan_cell_common::is_mesh_file(file)) return std::make_unique<CloudReference>(surface);
  return std::make_unique<MeshReference>(scan_cell_common::load_mesh(file, metres_per_unit),
                                         surface, file);
}

}  // namespace part_recipes
