// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/clouds/cloud_files.h"

#include <fmt/format.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "clouds/cloud_writers.h"
#include "files/scalars.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

// PCL's readers are not used: they trust what a file says of itself. Of 1500 small
// changes to a valid file each, PCL 1.13 crashed on 5 to 172 (PCD, OBJ, binary PLY), did not return
// on some (PLY, PCD), and asked for as many bytes as the header claims on the others.

namespace scan_cell_common {
namespace {

bool is_finite(const pcl::PointXYZ& point) {
  return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

const std::vector<std::string> kTextEndings = {".xyz", ".csv", ".txt", ".asc"};

bool is_one_of(const std::string& ending, const std::vector<std::string>& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool has_profiles(const CloudFormat& format) {
  const bool columns = format.column_step != 0;
  const bool profiles = format.profile_step != 0;
  if (columns != profiles) {
    throw InvalidParameter(columns ? "profile_step" : "column_step", "0",
                           "give both steps of depth profiles, or none for points");
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

/// Drops what stands for no measurement, and makes metres of the rest.
void finish(const std::string& path, const CloudFormat& format, LoadedCloud& loaded) {
  Cloud& cloud = loaded.cloud;
  const std::size_t before = cloud.size();
  if (!has_profiles(format)) {  // their reader has dropped them
    for (const double invalid : format.invalid) {
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
  if (format.metres_per_unit != 1) scale(cloud, format.metres_per_unit);
  cloud.is_dense = std::all_of(cloud.begin(), cloud.end(), is_finite);
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
  const bool profiles = has_profiles(format);
  const std::string extension = extension_of(path);
  const bool text = is_one_of(extension, kTextEndings);
  if (!text && extension != ".ply" && extension != ".pcd") {
    throw FileError(path, "ending '" + extension + "'",
                    "give a cloud as .ply, .pcd, .xyz, .csv, .txt or .asc");
  }
  if (profiles && !text) {
    throw InvalidParameter("column_step", path + " is no depth profiles",
                           "give the steps for profiles in .csv or .txt alone");
  }
  const std::string bytes = read_file(path);
  LoadedCloud loaded;
  if (profiles) {
    loaded = parse_depth_profiles(bytes, path, format);
  } else if (text) {
    loaded = parse_point_table(bytes, path, format.metres_per_unit);
  } else if (extension == ".pcd") {
    loaded.cloud = parse_pcd(bytes, path);
  } else {
    loaded.cloud = parse_ply(bytes, path);
    const std::size_t faces = faces_of_ply(bytes);
    if (faces > 0) {
      loaded.notes.push_back(
          fmt::format("its {} faces are left out: its vertices are taken for the points", faces));
    }
  }
  finish(path, format, loaded);
  return loaded;
}

Cloud load_cloud(const std::string& path, double metres_per_unit) {
  CloudFormat format;
  format.metres_per_unit = metres_per_unit;
  return load_cloud_file(path, format).cloud;
}

pcl::PolygonMesh load_mesh(const std::string& path, double metres_per_unit) {
  const std::string extension = extension_of(path);
  if (!is_one_of(extension, {".stl", ".obj", ".ply"})) {
    throw FileError(path, "ending '" + extension + "'", "give a mesh as .stl, .obj or .ply");
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
  check_cloud_output(path);
  const bool ply = extension_of(path) == ".ply";
  Cloud scaled;
  if (metres_per_unit != 1) {
    scaled = cloud;
    scale(scaled, 1 / metres_per_unit);
  }
  const Cloud& written = metres_per_unit == 1 ? cloud : scaled;
  save_whole(path, [&](const std::string& partial) {
    return ply ? write_ply(partial, written) : write_pcd(partial, written);
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
