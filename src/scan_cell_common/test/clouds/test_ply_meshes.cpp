// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <cmath>

#include "clouds/scratch_folder.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"

using namespace scan_cell_common;  // NOLINT

namespace {

/// A square of side 2 with a notch: its six corners, one of them concave.
constexpr float kCorners[6][3] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}};
constexpr double kArea = 3;

struct Types {
  const char* count;
  const char* index;
};

template <class Number>
void append(std::string& bytes, Number number, bool big) {
  const char* const begin = reinterpret_cast<const char*>(&number);
  const std::string raw(begin, sizeof(number));
  bytes += big ? std::string(raw.rbegin(), raw.rend()) : raw;
}

void append_as(std::string& bytes, const std::string& type, int number, bool big) {
  if (type == "uchar") append(bytes, static_cast<std::uint8_t>(number), big);
  if (type == "short") append(bytes, static_cast<std::int16_t>(number), big);
  if (type == "int") append(bytes, static_cast<std::int32_t>(number), big);
  if (type == "uint") append(bytes, static_cast<std::uint32_t>(number), big);
}

/// A mesh as written by noether's tools and CloudCompare: with normals and colours of the vertices,
/// and more properties of the faces.
std::string ply_mesh(const std::string& format, const std::vector<std::vector<int>>& faces,
                     const Types& types = {"uchar", "int"}) {
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment made\nelement vertex 6\nproperty float x\nproperty float y\n"
                      "property float z\nproperty float nx\nproperty uchar red\nelement face " +
                      std::to_string(faces.size()) + "\nproperty uchar flags\nproperty list " +
                      types.count + " " + types.index + " vertex_indices\nproperty list uchar " +
                      "float texcoord\nend_header\n";
  const bool ascii = format == "ascii", big = format == "binary_big_endian";
  for (const auto& corner : kCorners) {
    if (ascii) {
      bytes += std::to_string(corner[0]) + " " + std::to_string(corner[1]) + " 0 1 255\n";
      continue;
    }
    for (const float value : {corner[0], corner[1], corner[2], 1.0F})
      append(bytes, value, big);
    bytes += '\xff';
  }
  for (const std::vector<int>& face : faces) {
    if (ascii) {
      bytes += "0 " + std::to_string(face.size());
      for (const int corner : face)
        bytes += " " + std::to_string(corner);
      bytes += " 1 0.5\n";
      continue;
    }
    bytes += '\0';
    append_as(bytes, types.count, static_cast<int>(face.size()), big);
    for (const int corner : face)
      append_as(bytes, types.index, corner, big);
    bytes += '\1';
    append(bytes, 0.5F, big);
  }
  return bytes;
}

/// Area of all triangles; each must turn left, as the polygon does.
double area_of(const pcl::PolygonMesh& mesh) {
  Cloud vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  double area = 0;
  for (const pcl::Vertices& triangle : mesh.polygons) {
    EXPECT_EQ(triangle.vertices.size(), 3U);
    const auto corner = [&](std::size_t i) {
      return vertices[static_cast<std::size_t>(triangle.vertices[i])].getVector3fMap();
    };
    const Eigen::Vector3f cross = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    EXPECT_GE(cross.z(), 0);
    area += static_cast<double>(cross.norm()) / 2;
  }
  return area;
}

std::string complaint(const std::string& bytes) {
  try {
    parse_ply_mesh(bytes, "f");
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing";
}

class PlyMeshFiles : public ScratchFolder {};

const std::vector<std::vector<int>> kNotched = {{0, 1, 2, 3, 4, 5}};

}  // namespace

TEST(PlyMesh, IsReadInEveryFormatWithAnyTypesOfItsLists) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const Types& types : {Types{"uchar", "int"}, Types{"int", "uint"}, Types{"uint", "short"},
                               Types{"uchar", "uchar"}, Types{"short", "int"}}) {
      SCOPED_TRACE(std::string(format) + types.count + types.index);
      const std::string bytes = ply_mesh(format, {{0, 1, 4}, {0, 4, 5}, {1, 2, 3, 4}}, types);
      EXPECT_EQ(faces_of_ply(bytes), 3U);
      const pcl::PolygonMesh mesh = parse_ply_mesh(bytes, "f");
      ASSERT_EQ(mesh.polygons.size(), 3U);
      EXPECT_EQ(mesh.polygons[2].vertices, (pcl::Indices{1, 2, 3, 4}));
      EXPECT_DOUBLE_EQ(area_of(triangulated(mesh, "f")), kArea);
    }
  }
}

TEST(PlyMesh, CutsPolygonsIntoTrianglesThatFillThemAlsoWhereTheyAreConcave) {
  for (int first = 0; first < 6; ++first) {
    std::vector<int> face;
    for (int i = 0; i < 6; ++i)
      face.push_back((first + i) % 6);
    const pcl::PolygonMesh mesh = triangulated(parse_ply_mesh(ply_mesh("ascii", {face}), "f"), "f");
    EXPECT_EQ(mesh.polygons.size(), 4U);
    EXPECT_NEAR(area_of(mesh), kArea, 1e-6) << first;
  }
}

TEST(PlyMesh, SaysWhatIsWrong) {
  EXPECT_NE(complaint(ply_mesh("ascii", {{0, 1, 6}})).find("a face with vertex 6 of 6"),
            std::string::npos);
  EXPECT_NE(complaint(ply_mesh("binary_little_endian", {{0, 1, -1}}))
                .find("a face with vertex 4294967295"),
            std::string::npos);
  EXPECT_NE(complaint(ply_mesh("ascii", {{0, 1, -1}})).find("'-1'; give whole numbers"),
            std::string::npos);
  EXPECT_NE(
      complaint(ply_mesh("ascii", {{0, 1}})).find("a face with 2 corners; give at least three"),
      std::string::npos);
  std::string other = ply_mesh("ascii", {{0, 1, 2}});
  other.replace(other.find("int vertex_indices"), 18, "float somethings  ");
  EXPECT_EQ(faces_of_ply(other), 0U);
  EXPECT_NE(complaint(other).find("not have exactly one list of corners"), std::string::npos);
  const std::string whole = ply_mesh("binary_big_endian", kNotched);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW(parse_ply_mesh(whole.substr(0, size), "f"), FileError) << size;
}

TEST_F(PlyMeshFiles, AreMeshesWhereTheyHaveFacesAndCloudsElsewhere) {
  const std::string mesh = write("mesh.ply", ply_mesh("binary_little_endian", kNotched));
  const std::string cloud = write("cloud.ply", ply_mesh("binary_little_endian", {}));
  EXPECT_TRUE(is_mesh_file(mesh));
  EXPECT_FALSE(is_mesh_file(cloud));
  EXPECT_FALSE(is_mesh_file(write("none.ply", "hello")));
  EXPECT_NEAR(area_of(load_mesh(mesh)), kArea, 1e-6);
  EXPECT_THROW(load_mesh(cloud), UnusableInput);
}

TEST_F(PlyMeshFiles, SayWhereTheirFacesAreLeftOut) {
  const LoadedCloud loaded = load_cloud_file(write("mesh.ply", ply_mesh("ascii", kNotched)), {});
  EXPECT_EQ(loaded.cloud.size(), 6U);
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_NE(loaded.notes[0].find("its 1 faces are left out"), std::string::npos);
}

TEST_F(PlyMeshFiles, ComeInMetresWhateverTheirUnit) {
  const std::string obj =
      "v 0 0 0\nv 2000 0 0\nv 2000 2000 0\nv 1000 2000 0\nv 1000 1000 0\n"
      "v 0 1000 0\nf 1 2 3 4 5 6\n";
  EXPECT_NEAR(area_of(load_mesh(write("part.obj", obj), metres_per("mm"))), kArea, 1e-6);
  EXPECT_NEAR(
      area_of(load_mesh(write("mesh.ply", ply_mesh("ascii", kNotched)), metres_per("inch"))),
      kArea * 0.0254 * 0.0254, 1e-9);
}

TEST_F(PlyMeshFiles, WrittenInAUnitComeBackInIt) {
  Cloud cloud;
  cloud.push_back({0.1F, -0.2F, 0.3F});
  for (const char* name : {"a.ply", "a.pcd"}) {
    const std::string path = (folder_ / name).string();
    save_cloud(path, cloud, metres_per("mm"));
    EXPECT_NEAR(load_cloud(path)[0].y, -200, 1e-4);
    EXPECT_TRUE(
        load_cloud(path, metres_per("mm"))[0].getVector3fMap().isApprox(cloud[0].getVector3fMap()));
  }
  EXPECT_THROW(check_cloud_output((folder_ / "a.xyz").string()), FileError);
  EXPECT_THROW(check_cloud_output((folder_ / "none/a.ply").string()), FileError);
  EXPECT_NO_THROW(check_cloud_output((folder_ / "b.PLY").string()));
}
