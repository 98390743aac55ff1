// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/cloud_files.h"

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"

// PCL's writers are used, its readers are not: they trust what a file says of itself. Of 1500 small
// changes to a valid file each, PCL 1.13 crashed on 5 to 172 (PCD, OBJ, binary PLY), did not return
// on some (PLY, PCD), and asked for as many bytes as the header claims on the others.

namespace scan_cell_common {
namespace {

bool is_finite(const pcl::PointXYZ& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".stl" || extension == ".obj";
}

Cloud load_cloud(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".ply" && extension != ".pcd") {
    throw FileError(path, "ending '" + extension + "'", "give a cloud as .ply or .pcd");
  }
  const std::string bytes = read_file(path);
  Cloud cloud = extension == ".ply" ? parse_ply(bytes, path) : parse_pcd(bytes, path);
  if (cloud.empty()) throw UnusableInput(path, "no points", "scan the part again");
  cloud.is_dense = std::all_of(cloud.begin(), cloud.end(), is_finite);
  return cloud;
}

pcl::PolygonMesh load_mesh(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".stl" && extension != ".obj") {
    throw FileError(path, "ending '" + extension + "'", "give a mesh as .stl or .obj");
  }
  const std::string bytes = read_file(path);
  pcl::PolygonMesh mesh = extension == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);
  if (mesh.polygons.empty()) {
    throw UnusableInput(path, "no triangles could be read", "export the part again as STL or OBJ");
  }
  return mesh;
}

void save_cloud(const std::string& path, const Cloud& cloud) {
  const std::string extension = extension_of(path);
  const bool ply = extension == ".ply";
  if (!ply && extension != ".pcd") {
    throw FileError(path, "ending '" + extension + "'", "write clouds as .ply or .pcd");
  }
  constexpr bool kBinary = true, kCamera = false;  // a camera is no vertex
  save_whole(path, [&](const std::string& partial) {
    try {
      return (ply ? pcl::PLYWriter().write(partial, cloud, kBinary, kCamera)
                  : pcl::io::savePCDFileBinary(partial, cloud)) >= 0;
    } catch (const pcl::IOException&) {
      return false;
    }
  });
}

std::size_t remove_non_finite(Cloud& cloud) {
  const std::size_t before = cloud.size();
  const auto bad = [](const pcl::PointXYZ& point) { return !is_finite(point); };
  cloud.erase(std::remove_if(cloud.begin(), cloud.end(), bad), cloud.end());
  cloud.is_dense = true;
  return before - cloud.size();
}

}  // namespace scan_cell_common
