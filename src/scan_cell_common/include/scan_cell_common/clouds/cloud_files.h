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

/// What the file of a cloud does not say of itself. Lengths are in the file's unit.
struct CloudFormat {
  double metres_per_unit = 1;   //!< of the file, as metres_per() gives it
  std::vector<double> invalid;  //!< stand for no measurement: see drop_invalid()
  double column_step = 0;       //!< of depth profiles, from column to column; 0: a list of points
  double profile_step = 0;      //!< of depth profiles, from line to line; 0: a list of points
};

/// A cloud from a file.
struct LoadedCloud {
  Cloud cloud;                     //!< [m]
  std::vector<std::string> notes;  //!< what was left out of the file, for a person
};

/// True where the file is a mesh, which load_mesh() reads: .stl, .obj, or a .ply with faces.
bool is_mesh_file(const std::string& path);

/// Reads a cloud in metres from PLY, PCD (x, y and z as float or double), or text (.xyz, .csv,
/// .txt, .asc: a point a line, or depth profiles, a profile a line). Points come as they are in the
/// file, NaN included. Of a PLY mesh the vertices are read.
/// @throw FileError if it is missing, unreadable, of another kind, or has no such x, y, z
/// @throw UnusableInput if it has no point
/// @throw InvalidParameter if one of the format's steps is 0 and the other is not, or they are
/// given for another kind of file
LoadedCloud load_cloud_file(const std::string& path, const CloudFormat& format);

/// The same, of files that need nothing said but their unit.
Cloud load_cloud(const std::string& path, double metres_per_unit = 1);

/// Reads a triangle mesh in metres from STL, OBJ or PLY; faces with more corners become triangles.
/// @throw FileError if it is missing, unreadable or of another kind
/// @throw UnusableInput if it has no triangle
pcl::PolygonMesh load_mesh(const std::string& path, double metres_per_unit = 1);

/// The parsers behind them; `source` names the bytes in errors. Not PCL's, as cloud_files.cpp says.
/// @throw FileError where the bytes make no sense or are truncated
Cloud parse_ply(std::string_view bytes, const std::string& source);
Cloud parse_pcd(std::string_view bytes, const std::string& source);             //!< as parse_ply()
pcl::PolygonMesh parse_ply_mesh(std::string_view bytes,                         //!< as parse_ply()
                                const std::string& source);                     //!< as parse_ply()
pcl::PolygonMesh parse_stl(std::string_view bytes, const std::string& source);  //!< as parse_ply()
pcl::PolygonMesh parse_obj(std::string_view bytes, const std::string& source);  //!< as parse_ply()

/// Faces of a PLY file whose header this is, or begins; 0 where it makes no sense or has no end.
std::size_t faces_of_ply(std::string_view header);

/// A point a line, its columns parted by semicolons, tabs, commas or blanks, with a header that
/// names x, y and z (also "x [mm]"), or without one and x, y, z first. Other columns are left out,
/// and noted. Not in metres but as it stands there; an empty field is NaN.
/// @param metres_per_unit must agree with the header's unit, where it names one
/// @throw FileError where the bytes make no sense
LoadedCloud parse_point_table(std::string_view bytes, const std::string& source,
                              double metres_per_unit = 1);

/// Depth profiles of a line scanner: a profile a line, z in each column. The point of line i and
/// column k is (k column_step, i profile_step, z). Where a field is empty, not finite or one of the
/// format's invalid numbers, there is no point. A first line of words is a header.
/// @throw FileError where the bytes make no sense
LoadedCloud parse_depth_profiles(std::string_view bytes, const std::string& source,
                                 const CloudFormat& format);

/// Faces with more than three corners cut into triangles, concave ones too.
/// @throw FileError if one has more than a thousand corners
pcl::PolygonMesh triangulated(const pcl::PolygonMesh& mesh, const std::string& source);

/// What save_cloud() would refuse, before there is anything to save.
/// @throw FileError if the ending is neither .ply nor .pcd, or the folder is not there
void check_cloud_output(const std::string& path);

/// Writes a binary cloud as PLY or PCD, by the file's ending. Whole or not at all: it is written
/// beside its place and then renamed; where that fails nothing is left behind.
/// @param metres_per_unit of the file
/// @throw FileError if it cannot be written or the ending is neither
void save_cloud(const std::string& path, const Cloud& cloud, double metres_per_unit = 1);

/// Throws away points that are not finite, and says how many.
std::size_t remove_non_finite(Cloud& cloud);

/// Throws away the points that a scanner wrote where it measured nothing, and says how many: those
/// with a coordinate equal to the number, or where that is 0, with z equal to it.
std::size_t drop_invalid(Cloud& cloud, double invalid);

/// A number that stands for no measurement: the same extreme value in many points, far from the
/// rest.
struct Sentinel {
  char axis = 'z';         //!< first of those that hold it
  double value = 0;        //!< in the cloud's unit
  std::size_t points = 0;  //!< that hold it
};

/// The first of a cloud's sentinels; none if it has none.
std::optional<Sentinel> find_sentinel(const Cloud& cloud);

}  // namespace scan_cell_common
