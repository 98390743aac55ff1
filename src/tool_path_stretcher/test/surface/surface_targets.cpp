// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_targets.h"

#include <cmath>

#include "scan_cell_common/clouds/cloud_files.h"
#include "tool_path_stretcher/surface.h"

namespace {

using namespace tool_path_stretcher;
using scan_cell_common::FuzzTarget;
using scan_cell_common::promise;

void check_surface(const Surface& surface) {
  promise(!surface.points.empty() && surface.points.size() == surface.normals.size(),
          "a normal for each point");
  promise(std::isfinite(surface.spacing) && surface.size > 0, "a size");
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    promise(surface.points[i].allFinite(), "finite points");
    promise(std::abs(surface.normals[i].norm() - 1) < 1e-6, "unit normals");
  }
}

std::string ascii_cloud() {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 60\nproperty float x\nproperty float y\n"
      "property float z\nend_header\n";
  for (int i = 0; i < 60; ++i) {
    const double x = 0.01 * (i % 10);
    const double y = 0.01 * (i / 10);
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(x * y) + "\n";
  }
  return text;
}

const char* const kMesh =
    "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0.1 0.1 0.01\nv 0.05 0.05 0.05\nf 1 2 3\nf 2 4 3\nf 1 2 5\n"
    "f 3 4 5 1\n";

}  // namespace

std::vector<FuzzTarget> surface_targets() {
  const std::vector<std::string> number_words = {"\n",   " ",     "0.05", "0.050000 0.050000",
                                                 "1e20", "1e-20", "3e38", "0.01"};
  const Eigen::Vector3d leaf(0.002, 0.002, 0.0005);
  return {{"cloud_surface",
           {ascii_cloud()},
           number_words,
           [leaf](const std::string& bytes) {
             check_surface(
                 surface_from_cloud(to_points(scan_cell_common::parse_ply(bytes, "f")), leaf, "f"));
           }},
          {"mesh_surface",
           {kMesh},
           number_words,
           [leaf](const std::string& bytes) {
             check_surface(surface_from_mesh(scan_cell_common::parse_obj(bytes, "f"), leaf, "f"));
           },
           1000}};  // 20,000 samples each
}
