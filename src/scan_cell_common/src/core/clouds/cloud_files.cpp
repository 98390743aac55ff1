// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clouds/cloud_files.h"

#include <fmt/format.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "clouds/carried_fields.h"
#include "clouds/cloud_writers.h"
#include "files/scalars.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

// PCL's readers are not used: they trust what a file says about itself. Of 1500 small changes to a
// valid file of each kind, PCL 1.13 crashed on 5 to 172 (PCD, OBJ, binary PLY), did not return on
// some (PLY, PCD), and asked for as many bytes as the header claims on the others.

namespace scan_cell_common {
namespace {

bool is_finite(const pcl::PointXYZ& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

const std::vector<std::string> kTextExtensions = {".xyz", ".csv", ".txt", ".asc"};

bool is_one_of(const std::string& extension, const std::vector<std::string>& extensions) {
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

bool has_profiles(const CloudFormat& format) {
  const bool columns = format.column_step != 0;
  const bool profiles = format.profile_step != 0;
  if (columns != profiles) {
    throw InvalidParameter(columns ? "profile_step" : "column_step", "0",
                           "give both steps for depth profiles, neither for points");
  }
  for (const double step : {format.column_step, format.profile_step}) {
    if (std::isfinite(step)) continue;
    throw InvalidParameter("column_step, profile_step", fmt::format("{}", step),
                           "give finite numbers");
  }
  return columns;
}

void scale(Cloud& cloud, double factor) {
  for (pcl::PointXYZ& point : cloud) {
    for (int axis = 0; axis < 3; ++axis)
      point.data[axis] = to_float(static_cast<double>(point.data[axis]) * factor);
  }
}

void scale(FieldedCloud& carried, double factor) {
  for (const std::string& prefix : place_prefixes()) {
    for (const std::size_t offset : offsets_of(carried.fields, prefix)) {
      for (std::size_t at = offset; at < carried.bytes.size(); at += carried.step) {
        float value = 0;
        std::memcpy(&value, &carried.bytes[at], sizeof value);
        value = to_float(static_cast<double>(value) * factor);
        std::memcpy(&carried.bytes[at], &value, sizeof value);
      }
    }
  }
}

/// Drops the fields of the points that drop_invalid() is about to drop.
void drop_carried(const Cloud& cloud, double invalid, FieldedCloud& carried) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < carried.size(); ++i) {
    if (holds_invalid(cloud[i], invalid)) continue;
    std::copy_n(&carried.bytes[i * carried.step], carried.step,
                &carried.bytes[kept++ * carried.step]);
  }
  carried.bytes.resize(kept * carried.step);
}

/// Drops points without a measurement, and converts the rest to metres.
void finish(const std::string& path, const CloudFormat& format, FieldedCloud* carried,
            LoadedCloud& loaded) {
  Cloud& cloud = loaded.cloud;
  const std::size_t before = cloud.size();
  if (!has_profiles(format)) {  // their reader has dropped them
    for (const double invalid : format.invalid) {
      if (carried != nullptr) drop_carried(cloud, invalid, *carried);
      const std::size_t dropped = drop_invalid(cloud, invalid);
      std::ostringstream text;
      text << dropped << " of " << before << " points hold the invalid number " << invalid;
      loaded.notes.push_back(text.str());
    }
  }
  if (cloud.empty()) {
    throw UnusableInput(path, before > 0 ? "no point holds a valid number" : "no points",
                        "scan the part again");
  }
  if (format.metres_per_unit != 1) {
    scale(cloud, format.metres_per_unit);
    if (carried != nullptr) scale(*carried, format.metres_per_unit);
  }
  cloud.is_dense = std::all_of(cloud.begin(), cloud.end(), is_finite);
}

/// @param carried null: not wanted
LoadedCloud load(const std::string& path, const CloudFormat& format, FieldedCloud* carried) {
  const bool profiles = has_profiles(format);
  const std::string extension = extension_of(path);
  const bool text = is_one_of(extension, kTextExtensions);
  if (!text && extension != ".ply" && extension != ".pcd") {
    throw FileError(path, "extension '" + extension + "'",
                    "give a cloud as .ply, .pcd, .xyz, .csv, .txt or .asc");
  }
  if (profiles && !text) {
    throw InvalidParameter("column_step", "given for " + path,
                           "give the steps only for depth profiles in .csv or .txt");
  }
  const std::string bytes = read_file(path);
  LoadedCloud loaded;
  if (profiles) {
    loaded = parse_depth_profiles(bytes, path, format);
  } else if (text) {
    loaded = parse_point_table(bytes, path, format.metres_per_unit);
  } else if (extension == ".pcd") {
    loaded.cloud = parse_pcd(bytes, path, carried);
  } else {
    loaded.cloud = parse_ply(bytes, path, carried);
    const std::size_t faces = faces_of_ply(bytes);
    if (faces > 0) {
      loaded.notes.push_back(
          fmt::format("its {} faces are left out; its vertices are the points", faces));
    }
  }
  finish(path, format, carried, loaded);
  return loaded;
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension != ".ply") return extension == ".stl" || extension == ".obj";
  constexpr std::size_t kLongestHeader = 65536;
  std::string header(kLongestHeader, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  header.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return faces_of_ply(header) > 0;
}

LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format) {
  return load(path, format, nullptr);
}

LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format,
                            FieldedCloud& carried) {
  carried = {};
  return load(path, format, &carried);
}

Cloud load_cloud(const std::string& path, double metres_per_unit) {
  CloudFormat format;
  format.metres_per_unit = metres_per_unit;
  return load_cloud_file(path, format).cloud;
}

pcl::PolygonMesh load_mesh(const std::string& path, double metres_per_unit) {
  const std::string extension = extension_of(path);
  if (!is_one_of(extension, {".stl", ".obj", ".ply"})) {
    throw FileError(path, "extension '" + extension + "'", "give a mesh as .stl, .obj or .ply");
  }
  const std::string bytes = read_file(path);
  pcl::PolygonMesh mesh = extension == ".stl"   ? parse_stl(bytes, path)
                          : extension == ".obj" ? parse_obj(bytes, path)
                                                : parse_ply_mesh(bytes, path);
  if (mesh.polygons.empty()) {
    throw UnusableInput(path, "no triangles could be read",
                        "export the part again as STL, OBJ or PLY");
  }
  mesh = triangulated(mesh, path);
  if (metres_per_unit != 1) {
    Cloud vertices;
    pcl::fromPCLPointCloud2(mesh.cloud, vertices);
    scale(vertices, metres_per_unit);
    pcl::toPCLPointCloud2(vertices, mesh.cloud);
  }
  return mesh;
}

void check_cloud_output(const std::string& path) {
  check_output(path, {".ply", ".pcd"}, "write clouds as .ply or .pcd");
}

void save_cloud(const std::string& path, const Cloud& cloud, double metres_per_unit) {
  const bool organised = std::size_t{cloud.width} * cloud.height == cloud.size();
  PointsToWrite points;
  points.fields = {{"x", FieldType::kFloat32, 0},
                   {"y", FieldType::kFloat32, sizeof(float)},
                   {"z", FieldType::kFloat32, 2 * sizeof(float)}};
  points.width = organised ? cloud.width : cloud.size();
  points.height = organised ? cloud.height : 1;
  points.at = [&cloud](std::size_t i) {
    return reinterpret_cast<const std::uint8_t*>(cloud[i].data);
  };
  write_cloud(path, points, metres_per_unit);
}

std::size_t remove_non_finite(Cloud& cloud) {
  const std::size_t before = cloud.size();
  const auto bad = [](const pcl::PointXYZ& point) { return !is_finite(point); };
  cloud.erase(std::remove_if(cloud.begin(), cloud.end(), bad), cloud.end());
  cloud.is_dense = true;
  return before - cloud.size();
}

}  // namespace scan_cell_common
