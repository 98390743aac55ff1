// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <string_view>

namespace scan_cell_common {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// True where the file's ending is that of a mesh (.stl, .obj), which load_mesh() reads.
bool is_mesh_file(const std::string& path);

/// Reads a cloud in metres from PLY or PCD, with x, y and z as float or double. Points come as they
/// are in the file, NaN included.
/// @throw FileError if it is missing, unreadable, of another kind, or has no such x, y, z
/// @throw UnusableInput if it has no point
Cloud load_cloud(const std::string& path);

/// Reads a triangle mesh in metres from STL or OBJ.
/// @throw FileError if it is missing, unreadable or of another kind
/// @throw UnusableInput if it has no triangle
pcl::PolygonMesh load_mesh(const std::string& path);

/// The parsers behind them; `source` names the bytes in errors. Not PCL's, as cloud_files.cpp says.
/// @throw FileError where the bytes make no sense or are truncated
Cloud parse_ply(std::string_view bytes, const std::string& source);
Cloud parse_pcd(std::string_view bytes, const std::string& source);
pcl::PolygonMesh parse_stl(std::string_view bytes, const std::string& source);
pcl::PolygonMesh parse_obj(std::string_view bytes, const std::string& source);

/// Writes a binary cloud as PLY or PCD, by the file's ending. Whole or not at all: it is written
/// beside its place and then renamed; where that fails nothing is left behind.
/// @throw FileError if it cannot be written or the ending is neither
void save_cloud(const std::string& path, const Cloud& cloud);

/// Throws away points that are not finite, and says how many.
std::size_t remove_non_finite(Cloud& cloud);

}  // namespace scan_cell_common
