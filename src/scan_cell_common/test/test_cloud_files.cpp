// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "scan_cell_common/cloud_files.h"
#include "scan_cell_common/errors.h"

namespace fs = std::filesystem;
using scan_cell_common::Cloud;

namespace {

class CloudFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("cloud_files_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

  fs::path folder_;
};

Cloud three_points() {
  Cloud cloud;
  cloud.push_back({0.1F, 0.2F, 0.3F});
  cloud.push_back({-1.0F, 2.0F, 1e-4F});
  cloud.push_back({3.0F, 0.0F, 0.0F});
  return cloud;
}

}  // namespace

TEST_F(CloudFiles, ComeBackAsTheyWereWritten) {
  for (const char* name : {"cloud.ply", "cloud.PCD"}) {
    scan_cell_common::save_cloud(path(name), three_points());
    const Cloud loaded = scan_cell_common::load_cloud(path(name));
    ASSERT_EQ(loaded.size(), 3U) << name;
    EXPECT_EQ(loaded[1].x, -1.0F);
    EXPECT_EQ(loaded[1].z, 1e-4F);
  }
}

TEST_F(CloudFiles, MayHaveDoublesForCoordinates) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\n"
      "property double y\nproperty float z\nproperty uchar red\nend_header\n"
      "0.5 -2.25 3 7\n1e-3 4 -5 8\n";
  const std::string pcd =
      "VERSION .7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\n"
      "HEIGHT 1\nPOINTS 2\nDATA ascii\n0.5 -2.25 3\n1e-3 4 -5\n";
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\n"
      "property double x\nproperty double y\nproperty double z\nend_header\n";
  for (const double value : {0.5, -2.25, 3.0, 1e-3, 4.0, -5.0})
    binary.append(reinterpret_cast<const char*>(&value), sizeof(value));
  for (const auto& file : {write("a.ply", ply), write("b.pcd", pcd), write("c.ply", binary)}) {
    const Cloud cloud = scan_cell_common::load_cloud(file);
    ASSERT_EQ(cloud.size(), 2U) << file;
    EXPECT_EQ(cloud[0].getVector3fMap(), Eigen::Vector3f(0.5F, -2.25F, 3)) << file;
    EXPECT_EQ(cloud[1].getVector3fMap(), Eigen::Vector3f(1e-3F, 4, -5)) << file;
  }
}

TEST_F(CloudFiles, AreRefusedWhereTheyCannotBeWrittenAndLeaveNothingBehind) {
  for (const char* name : {"taken.ply", "taken.pcd"}) {
    fs::create_directories(path(name));
    try {
      scan_cell_common::save_cloud(path(name), three_points());
      ADD_FAILURE() << name;
    } catch (const scan_cell_common::FileError& error) {
      EXPECT_EQ(error.thing(), path(name));
    }
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2);
}

TEST_F(CloudFiles, AreRefusedByNameWhenMissingOrBroken) {
  using scan_cell_common::FileError;
  EXPECT_THROW(scan_cell_common::load_cloud(path("missing.ply")), FileError);
  EXPECT_THROW(scan_cell_common::load_cloud(write("text.ply", "hello\n")), FileError);
  EXPECT_THROW(scan_cell_common::load_cloud(write("cloud.xyz", "0 0 0\n")), FileError);
  EXPECT_THROW(scan_cell_common::load_cloud(
                   write("whole.pcd",
                         "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE I I I\nCOUNT 1 1 1\nWIDTH 1\n"
                         "HEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n")),
               FileError);
  EXPECT_THROW(scan_cell_common::save_cloud(path("no/such/folder/cloud.ply"), three_points()),
               FileError);
  EXPECT_THROW(scan_cell_common::save_cloud(path("cloud.xyz"), three_points()), FileError);
}

TEST_F(CloudFiles, WithoutPointsOrTrianglesAreUnusable) {
  const std::string empty_ply = write("empty.ply",
                                      "ply\nformat ascii 1.0\nelement vertex 0\n"
                                      "property float x\nproperty float y\nproperty float z\n"
                                      "end_header\n");
  EXPECT_THROW(scan_cell_common::load_cloud(empty_ply), scan_cell_common::Error);
  EXPECT_THROW(scan_cell_common::load_mesh(write("empty.stl", "solid a\nendsolid a\n")),
               scan_cell_common::UnusableInput);
}

TEST_F(CloudFiles, ReadsMeshes) {
  const std::string stl = write("part.stl",
                                "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n");
  EXPECT_EQ(scan_cell_common::load_mesh(stl).polygons.size(), 1U);
  EXPECT_EQ(scan_cell_common::load_mesh(write("part.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"))
                .polygons.size(),
            1U);
  EXPECT_TRUE(scan_cell_common::is_mesh_file("PART.STL"));
  EXPECT_FALSE(scan_cell_common::is_mesh_file("part.ply"));
}

TEST(RemoveNonFinite, CountsWhatItThrowsAway) {
  Cloud cloud = three_points();
  cloud.push_back({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  cloud.push_back({0, std::numeric_limits<float>::infinity(), 0});
  EXPECT_EQ(scan_cell_common::remove_non_finite(cloud), 2U);
  EXPECT_EQ(cloud.size(), 3U);
}
