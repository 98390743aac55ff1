// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <filesystem>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scanner_views/parts/part_list.h"
#include "tool_paths/tool_path_files.h"

namespace scanner_views {
namespace {

namespace fs = std::filesystem;

/// A file of parts/meshes; its path is random.
struct MeshFile {
  const char* name;
  const char* file;
  double metres_per_unit;
};

constexpr std::array kMeshes = {MeshFile{"sander", "crs_sander.stl", 1},
                                MeshFile{"mounting plate", "godel_mounting_plate.stl", 1},
                                // Its unit is unknown: taken as a sheet of 0.26 m
                                MeshFile{"wavy sheet with a hole", "noether_wavy.ply", 0.025}};

Mesh load(const fs::path& file, double metres_per_unit) {
  return from_polygon_mesh(scan_cell_common::load_mesh(file.string(), metres_per_unit));
}

}  // namespace

std::vector<ViewPart> real_parts(const std::string& data) {
  std::vector<ViewPart> parts;
  if (data.empty()) return parts;
  for (const char* name : {"crs_part_1", "crs_part_2"}) {
    const fs::path folder = fs::path(data) / "parts" / name;
    if (!fs::exists(folder)) continue;
    parts.push_back({name, load(folder / "part.stl", 1), false,
                     tool_paths::load_tool_path((folder / "toolpath.yaml").string())});
  }
  for (const MeshFile& each : kMeshes) {
    const fs::path file = fs::path(data) / "parts" / "meshes" / each.file;
    if (fs::exists(file)) parts.push_back({each.name, load(file, each.metres_per_unit)});
  }
  return parts;
}

}  // namespace scanner_views
