// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scan_cell_common {

/// Points in metres.
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// What a cloud file does not say about itself. Lengths are in the file's unit.
struct CloudFormat {
  double metres_per_unit = 1;   //!< of the file, from metres_per()
  std::vector<double> invalid;  //!< values that mean no measurement; see drop_invalid()
  double column_step = 0;       //!< between columns of depth profiles; 0: a list of points
  double profile_step = 0;      //!< between lines of depth profiles; 0: a list of points
};

/// A cloud from a file.
struct LoadedCloud {
  Cloud cloud;                     //!< [m]
  std::vector<std::string> notes;  //!< what was left out of the file, for a person
};

/// Whether the file is a mesh, for load_mesh(): .stl, .obj, or a .ply with faces.
bool is_mesh_file(const std::string& path);

/// Reads a cloud in metres from PLY, PCD (x, y and z as float or double), or text (.xyz, .csv,
/// .txt, .asc: one point per line, or depth profiles, one profile per line). Points are returned as
/// in the file, NaN included. Of a PLY mesh, the vertices are read.
/// @throw FileError if it is missing, unreadable, of another kind, or has no such x, y, z
/// @throw UnusableInput if it has no point
/// @throw InvalidParameter if only one of the format's steps is 0, or they are given for another
/// kind of file
LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format);

/// The same for files that only need their unit.
Cloud load_cloud(const std::string& path, double metres_per_unit = 1);

/// Reads a triangle mesh in metres from STL, OBJ or PLY; faces with more corners become triangles.
/// @throw FileError if it is missing, unreadable or of another kind
/// @throw UnusableInput if it has no triangle
pcl::PolygonMesh load_mesh(const std::string& path, double metres_per_unit = 1);

/// The parsers behind these functions; `source` names the bytes in errors. cloud_files.cpp says why
/// they are not PCL's.
/// @throw FileError if the bytes are invalid or truncated
Cloud parse_ply(std::string_view bytes, const std::string& source);
Cloud parse_pcd(std::string_view bytes, const std::string& source);             //!< as parse_ply()
pcl::PolygonMesh parse_ply_mesh(std::string_view bytes,                         //!< as parse_ply()
                                const std::string& source);                     //!< as parse_ply()
pcl::PolygonMesh parse_stl(std::string_view bytes, const std::string& source);  //!< as parse_ply()
pcl::PolygonMesh parse_obj(std::string_view bytes, const std::string& source);  //!< as parse_ply()

/// Number of faces of a PLY file from its header, which may be followed by more; 0 if the header is
/// invalid or incomplete.
std::size_t faces_of_ply(std::string_view header);

/// Reads one point per line, with columns separated by semicolons, tabs, commas or blanks. A header
/// names x, y and z (also "x [mm]"); without one, x, y, z come first. Other columns are left out
/// and noted. Values stay in the file's unit; an empty field is NaN.
/// @param metres_per_unit must agree with the header's unit, if it names one
/// @throw FileError if the bytes are invalid
LoadedCloud parse_point_table(std::string_view bytes, const std::string& source,
                              double metres_per_unit = 1);

/// Reads depth profiles of a line scanner: one profile per line, z in each column. The point of
/// line i and column k is (k column_step, i profile_step, z). A field that is empty, not finite or
/// one of the format's invalid numbers gives no point. A first line of words is a header.
/// @throw FileError if the bytes are invalid
LoadedCloud parse_depth_profiles(std::string_view bytes, const std::string& source,
                                 const CloudFormat& format);

/// Cuts faces with more than three corners into triangles, concave ones too.
/// @throw FileError if one has more than a thousand corners
pcl::PolygonMesh triangulated(const pcl::PolygonMesh& mesh, const std::string& source);

/// Checks in advance what save_cloud() would refuse.
/// @throw FileError if the extension is neither .ply nor .pcd, or the folder does not exist
void check_cloud_output(const std::string& path);

/// Writes a binary cloud as PLY or PCD, by the file's extension. Whole or not at all: it writes a
/// temporary file beside it and renames that; on failure nothing is left behind.
/// @param metres_per_unit of the file
/// @throw FileError if it cannot be written or the extension is neither
void save_cloud(const std::string& path, const Cloud& cloud, double metres_per_unit = 1);

/// Removes points that are not finite, and returns their number.
std::size_t remove_non_finite(Cloud& cloud);

/// Removes the points that a scanner wrote where it measured nothing, and returns their number:
/// those with a coordinate equal to `invalid` or, if it is 0, those with z = 0.
std::size_t drop_invalid(Cloud& cloud, double invalid);

/// A number that means no measurement: the same extreme value in many points, far from the rest.
struct Sentinel {
  char axis = 'z';         //!< first axis that holds it
  double value = 0;        //!< in the cloud's unit
  std::size_t points = 0;  //!< number that hold it
};

/// The first sentinel of a cloud, if it has one.
std::optional<Sentinel> find_sentinel(const Cloud& cloud);

}  // namespace scan_cell_common
