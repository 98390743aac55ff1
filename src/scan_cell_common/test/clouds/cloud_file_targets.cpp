// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_file_targets.h"

#include <lzf.h>

#include <array>

#include "scan_cell_common/clouds/cloud_files.h"

namespace {

using namespace scan_cell_common;

constexpr int kPoints = 12;

template <class Number>
void append(std::string& bytes, Number number, bool big_endian = false) {
  const char* const begin = reinterpret_cast<const char*>(&number);
  std::string raw(begin, sizeof(number));
  bytes += big_endian ? std::string(raw.rbegin(), raw.rend()) : raw;
}

float coordinate(int point, int axis) {
  return 0.01F * static_cast<float>((point * 37 + axis * 11) % 50) - 0.1F;
}

std::string ascii_points(const std::string& before, const std::string& after) {
  std::string text;
  for (int i = 0; i < kPoints; ++i) {
    text += before;
    for (int axis = 0; axis < 3; ++axis)
      text += (axis > 0 ? " " : "") + std::to_string(coordinate(i, axis));
    text += after + "\n";
  }
  return text;
}

std::string ply(const std::string& format) {
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment made by hand\nelement camera 1\nproperty int id\n"
                      "element vertex 12\nproperty float x\nproperty double y\nproperty float z\n"
                      "property uchar red\nproperty list uchar short tags\n"
                      "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
  if (format == "ascii")
    return bytes + "5\n" + ascii_points("", " 255 2 1 2") + "3 0 1 2\n3 2 3 4\n";
  const bool big = format == "binary_big_endian";
  append(bytes, 5, big);
  for (int i = 0; i < kPoints; ++i) {
    append(bytes, coordinate(i, 0), big);
    append(bytes, static_cast<double>(coordinate(i, 1)), big);
    append(bytes, coordinate(i, 2), big);
    bytes += std::string("\xff\x02", 2);
    append(bytes, std::int16_t{1}, big);
    append(bytes, std::int16_t{2}, big);
  }
  for (const int first : {0, 2}) {
    bytes += '\x03';
    for (int i = 0; i < 3; ++i)
      append(bytes, first + i, big);
  }
  return bytes;
}

std::string pcd(const std::string& data) {
  std::string bytes =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS rgb x y z tag\n"
      "SIZE 4 4 8 4 2\nTYPE U F F F I\nCOUNT 1 1 1 1 2\nWIDTH 4\nHEIGHT 3\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 12\nDATA " +
      data + "\n";
  if (data == "ascii") return bytes + ascii_points("7 ", " 1 2");
  std::string rows;
  std::array<std::string, 5> fields;
  for (int i = 0; i < kPoints; ++i) {
    std::array<std::string, 5> row;
    append(row[0], 7);
    append(row[1], coordinate(i, 0));
    append(row[2], static_cast<double>(coordinate(i, 1)));
    append(row[3], coordinate(i, 2));
    append(row[4], 12345);
    for (std::size_t field = 0; field < row.size(); ++field) {
      rows += row[field];
      fields[field] += row[field];
    }
  }
  if (data == "binary") return bytes + rows;
  std::string together;
  for (const std::string& field : fields)
    together += field;
  std::string packed(2 * together.size(), '\0');
  packed.resize(lzf_compress(together.data(), static_cast<unsigned>(together.size()), packed.data(),
                             static_cast<unsigned>(packed.size())));
  append(bytes, static_cast<std::uint32_t>(packed.size()));
  append(bytes, static_cast<std::uint32_t>(together.size()));
  return bytes + packed;
}

std::string ascii_stl() {
  std::string text = "solid part\n";
  for (int i = 0; i < 4; ++i) {
    text += "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0." +
            std::to_string(i) + "\n endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

std::string binary_stl() {
  std::string bytes(80, ' ');
  append(bytes, 4);
  for (int i = 0; i < 4; ++i) {
    for (const float number : {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, i})
      append(bytes, number);
    append(bytes, std::int16_t{0});
  }
  return bytes;
}

const char* const kObj =
    "# part\nmtllib part.mtl\no part\nv 0 0 0\nv 1 0 0\nv 0 1 0 1.0\nv 1 1 0.5\nvt 0 0\nvn 0 0 1\n"
    "usemtl grey\nf 1 2 3\nf 2/1/1 3/1/1 4/1/1\nf 1//1 2//1 4//1 3//1\nf -1 -2 -3\n";

const char* const kTable =
    "time,x [m],y [m],z [m],label\n1,0.1,0.2,0.3,a\n2,0.1,,0.3,b\n3,\"0.1\",0.2,nan,c\n";
const char* const kXyz = "//X Y Z R\n0.1 0.2 0.3 7\n0.1 0.2 0.4 7\n-0.1 0.2 0.5 8\n";
const char* const kSemicolons = "# scanned\n0.1;0.2;0.3;7\n0.1;0.2;;7\n-0.1;0.2;0.5;8\n";
const char* const kProfiles =
    "z0\tz1\tz2\n0.1\t-32.768\t0.3\n\tnan\t0.4\n0.1\t0.2\t0.3\n-32.768\t0.1\t0.3\n";

/// Checks that a reader makes no more of a file than is in it.
void check_cloud(const Cloud& cloud, const std::string& bytes) {
  constexpr std::size_t kMinRow = 3;          // ",," and the line's end
  constexpr std::size_t kMaxRatio = 264 / 3;  // of LZF
  const bool packed = bytes.find("binary_compressed") != std::string::npos;
  promise(cloud.size() == std::size_t{cloud.width} * cloud.height, "points are width x height");
  promise(kMinRow * cloud.size() <= (packed ? kMaxRatio : 1) * bytes.size() + 1,
          "no more points than the file can hold");
}

void check_mesh(const pcl::PolygonMesh& mesh, const std::string& bytes) {
  const std::size_t vertices = std::size_t{mesh.cloud.width} * mesh.cloud.height;
  promise(8 * vertices <= bytes.size() + 1, "no more vertices than the file can hold");
  promise(6 * mesh.polygons.size() <= bytes.size() + 1, "no more faces than the file can hold");
  promise(mesh.cloud.data.size() == vertices * mesh.cloud.point_step, "vertices as promised");
  for (const pcl::Vertices& polygon : mesh.polygons) {
    promise(polygon.vertices.size() >= 3, "three corners at least");
    for (const pcl::index_t corner : polygon.vertices)
      promise(corner >= 0 && static_cast<std::size_t>(corner) < vertices, "corners that exist");
  }
}

}  // namespace

std::vector<FuzzTarget> cloud_file_targets() {
  const std::vector<std::string> ply_words = {"ply",
                                              "format",
                                              "ascii",
                                              "binary_little_endian",
                                              "binary_big_endian",
                                              "1.0",
                                              "element",
                                              "vertex",
                                              "face",
                                              "property",
                                              "list",
                                              "char",
                                              "uchar",
                                              "short",
                                              "int",
                                              "uint",
                                              "float",
                                              "double",
                                              "x",
                                              "y",
                                              "z",
                                              "comment",
                                              "\n",
                                              "\r\n",
                                              "end_header\n",
                                              " ",
                                              "obj_info",
                                              "int8",
                                              "element vertex 3\n",
                                              "property float x\n"};
  const std::vector<std::string> pcd_words = {"VERSION",
                                              "FIELDS",
                                              "SIZE",
                                              "TYPE",
                                              "COUNT",
                                              "WIDTH",
                                              "HEIGHT",
                                              "POINTS",
                                              "DATA",
                                              "ascii",
                                              "binary",
                                              "binary_compressed",
                                              "DATA ascii\n",
                                              "x",
                                              "y",
                                              "z",
                                              "_",
                                              "F",
                                              "I",
                                              "U",
                                              "4",
                                              "8",
                                              "\n",
                                              "\r\n",
                                              " ",
                                              "#"};
  const std::vector<std::string> stl_words = {"solid",    "facet",  "normal",  "outer",
                                              "loop",     "vertex", "endloop", "endfacet",
                                              "endsolid", "\n",     "\r\n",    " "};
  const std::vector<std::string> obj_words = {"v",  "f",  "vt",   "vn", "/", "//",
                                              "-1", "\n", "\r\n", " ",  "#", "\\\n"};
  const std::vector<std::string> table_words = {
      "x",   "y",  "z", "x [mm]", ",",  ";",    "\t", "\n",   " ", "\r\n",
      "nan", "\"", "#", "//",     ",,", "\"\"", "m",  "z_mm", "",  "points:0"};
  return {{"ply",
           {ply("ascii"), ply("binary_little_endian"), ply("binary_big_endian")},
           ply_words,
           [](const std::string& bytes) {
             check_cloud(parse_ply(bytes, "f"), bytes);
             faces_of_ply(bytes);
           }},
          {"ply_mesh",
           {ply("ascii"), ply("binary_little_endian"), ply("binary_big_endian")},
           ply_words,
           [](const std::string& bytes) {
             const pcl::PolygonMesh mesh = parse_ply_mesh(bytes, "f");
             check_mesh(mesh, bytes);
             std::size_t triangles = 0;
             for (const pcl::Vertices& polygon : mesh.polygons)
               triangles += polygon.vertices.size() - 2;
             promise(triangulated(mesh, "f").polygons.size() == triangles,
                     "a polygon of n corners is n - 2 triangles");
           }},
          {"pcd",
           {pcd("ascii"), pcd("binary"), pcd("binary_compressed")},
           pcd_words,
           [](const std::string& bytes) { check_cloud(parse_pcd(bytes, "f"), bytes); }},
          {"point_table",
           {kTable, kXyz, kSemicolons},
           table_words,
           [](const std::string& bytes) {
             const LoadedCloud loaded = parse_point_table(bytes, "f");
             check_cloud(loaded.cloud, bytes);
             find_sentinel(loaded.cloud);
           }},
          {"depth_profiles",
           {kProfiles, kSemicolons},
           table_words,
           [](const std::string& bytes) {
             CloudFormat format;
             format.column_step = 0.1;
             format.profile_step = -0.2;
             format.invalid = {-32.768};
             const Cloud cloud = parse_depth_profiles(bytes, "f", format).cloud;
             promise(2 * cloud.size() <= bytes.size() + 1, "no more points than fields");
           }},
          {"stl",
           {ascii_stl(), binary_stl()},
           stl_words,
           [](const std::string& bytes) { check_mesh(parse_stl(bytes, "f"), bytes); }},
          {"obj", {kObj}, obj_words, [](const std::string& bytes) {
             check_mesh(parse_obj(bytes, "f"), bytes);
           }}};
}
