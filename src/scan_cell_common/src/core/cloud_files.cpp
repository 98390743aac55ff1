// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/cloud_files.h"

#include <pcl/io/obj_io.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/io/vtk_lib_io.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "scan_cell_common/errors.h"

namespace scan_cell_common {
namespace {

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

void require_file(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw FileError(path, "no such file", "check the path");
  }
}

bool is_coordinate(const pcl::PCLPointField& field) {
  return field.name == "x" || field.name == "y" || field.name == "z";
}

/// Makes coordinates that are doubles, as many programs write them, the floats that PCL reads; it
/// would take others for zero in silence.
void narrow_doubles(pcl::PCLPointCloud2& cloud) {
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  for (pcl::PCLPointField& field : cloud.fields) {
    if (!is_coordinate(field) || field.datatype != pcl::PCLPointField::FLOAT64) continue;
    for (std::size_t point = 0; point < points; ++point) {
      std::uint8_t* const place = &cloud.data.at(point * cloud.point_step + field.offset);
      double wide = 0;
      std::memcpy(&wide, place, sizeof(wide));
      const auto narrow = static_cast<float>(wide);
      std::memcpy(place, &narrow, sizeof(narrow));
    }
    field.datatype = pcl::PCLPointField::FLOAT32;
  }
}

bool has_xyz(const pcl::PCLPointCloud2& cloud) {
  return std::count_if(cloud.fields.begin(), cloud.fields.end(), [](const auto& field) {
           return is_coordinate(field) && field.datatype == pcl::PCLPointField::FLOAT32 &&
                  field.count == 1;
         }) == 3;
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string extension = lower_extension(path);
  return extension == ".stl" || extension == ".obj";
}

Cloud load_cloud(const std::string& path) {
  require_file(path);
  const std::string extension = lower_extension(path);
  pcl::PCLPointCloud2 blob;
  int status = -1;
  if (extension == ".ply") {
    status = pcl::PLYReader().read(path, blob);
  } else if (extension == ".pcd") {
    status = pcl::PCDReader().read(path, blob);
  } else {
    throw FileError(path, "ending '" + extension + "'", "give a cloud as .ply or .pcd");
  }
  if (status >= 0) narrow_doubles(blob);
  if (status < 0 || !has_xyz(blob)) {
    throw FileError(path, "not a readable cloud with x, y and z",
                    "write it again as PLY or PCD, with x, y and z as float or double");
  }
  Cloud cloud;
  pcl::fromPCLPointCloud2(blob, cloud);
  if (cloud.empty()) throw UnusableInput(path, "no points", "scan the part again");
  return cloud;
}

pcl::PolygonMesh load_mesh(const std::string& path) {
  require_file(path);
  const std::string extension = lower_extension(path);
  pcl::PolygonMesh mesh;
  if (extension == ".stl") {
    pcl::io::loadPolygonFileSTL(path, mesh);
  } else if (extension == ".obj") {
    pcl::io::loadOBJFile(path, mesh);
  } else {
    throw FileError(path, "ending '" + extension + "'", "give a mesh as .stl or .obj");
  }
  if (mesh.polygons.empty()) {
    throw UnusableInput(path, "no triangles could be read", "export the part again as STL or OBJ");
  }
  return mesh;
}

void save_cloud(const std::string& path, const Cloud& cloud) {
  const std::string extension = lower_extension(path);
  const bool ply = extension == ".ply";
  if (!ply && extension != ".pcd") {
    throw FileError(path, "ending '" + extension + "'", "write clouds as .ply or .pcd");
  }
  constexpr bool kBinary = true, kCamera = false;  // PCL's own reader warns about its camera
  const std::string partial = path + ".partial";
  std::string reason;
  try {
    const int status = ply ? pcl::PLYWriter().write(partial, cloud, kBinary, kCamera)
                           : pcl::io::savePCDFileBinary(partial, cloud);
    if (status < 0) reason = "cannot be written";
  } catch (const pcl::IOException& error) {
    reason = error.what();
  }
  std::error_code failure;
  if (reason.empty()) std::filesystem::rename(partial, path, failure);
  if (failure) reason = "cannot be written (" + failure.message() + ")";
  if (reason.empty()) return;
  std::filesystem::remove(partial, failure);
  throw FileError(path, reason, "check the folder and its permissions");
}

std::size_t remove_non_finite(Cloud& cloud) {
  const std::size_t before = cloud.size();
  const auto not_finite = [](const pcl::PointXYZ& point) {
    return !std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z);
  };
  cloud.erase(std::remove_if(cloud.begin(), cloud.end(), not_finite), cloud.end());
  cloud.is_dense = true;
  return before - cloud.size();
}

}  // namespace scan_cell_common
