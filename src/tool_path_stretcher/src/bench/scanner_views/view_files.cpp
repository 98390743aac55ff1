// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/view_files.h"

#include <pcl/io/ply_io.h>

#include <cstddef>
#include <filesystem>

#include "scan_cell_common/clouds/fielded_cloud.h"
#include "tool_paths/tool_path_files.h"

namespace scanner_views {
namespace {

namespace fs = std::filesystem;
using scan_cell_common::FieldType;

/// The fields that laser_triangulation's points have too.
struct FilePoint {
  float x, y, z;
  std::uint8_t laser, pass;
  std::uint8_t padding[2] = {0, 0};
  float vp_x, vp_y, vp_z;
};

void save(const std::string& file, const ScanPoints& points) {
  std::vector<FilePoint> written;
  for (std::size_t i = 0; i < points.places.size(); ++i) {
    const Eigen::Vector3f at = points.places[i].cast<float>(),
                          from = points.seen_from[i].cast<float>();
    FilePoint point{};
    point.x = at.x(), point.y = at.y(), point.z = at.z();
    point.laser = points.lasers[i], point.pass = points.passes[i];
    point.vp_x = from.x(), point.vp_y = from.y(), point.vp_z = from.z();
    written.push_back(point);
  }
  scan_cell_common::save_cloud(file,
                               {{"x", FieldType::kFloat32, offsetof(FilePoint, x)},
                                {"y", FieldType::kFloat32, offsetof(FilePoint, y)},
                                {"z", FieldType::kFloat32, offsetof(FilePoint, z)},
                                {"laser", FieldType::kUint8, offsetof(FilePoint, laser)},
                                {"pass", FieldType::kUint8, offsetof(FilePoint, pass)},
                                {"vp_x", FieldType::kFloat32, offsetof(FilePoint, vp_x)},
                                {"vp_y", FieldType::kFloat32, offsetof(FilePoint, vp_y)},
                                {"vp_z", FieldType::kFloat32, offsetof(FilePoint, vp_z)}},
                               written.size(), [&written](std::size_t i) {
                                 return reinterpret_cast<const std::uint8_t*>(&written[i]);
                               });
}

}  // namespace

void write_files(const View& view, const std::string& folder) {
  fs::create_directories(folder);
  const auto file = [&folder](const char* name) { return (fs::path(folder) / name).string(); };
  if (view.reference_mesh) {
    pcl::io::savePLYFileBinary(file("reference.ply"), *view.reference_mesh);
  } else {
    save(file("reference.ply"), view.reference_scan);
  }
  save(file("object.ply"), view.object);
  if (!view.scan.places.empty()) save(file("scan.ply"), view.scan);
  tool_paths::save_tool_path(file("path.csv"), view.path);
  tool_paths::save_tool_path(file("truth.csv"), view.truth);
}

}  // namespace scanner_views
