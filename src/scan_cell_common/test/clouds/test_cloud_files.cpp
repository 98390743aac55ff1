// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"

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

TEST_F(CloudFiles, AreReadByPclAsTheyWereWritten) {
  Cloud organised(2, 2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int i = 0; i < 4; ++i)
    organised[static_cast<std::size_t>(i)] = {0.1F * static_cast<float>(i), i == 2 ? nan : -1e-4F,
                                              7};
  Cloud large;
  for (int i = 0; i < 200000; ++i)
    large.push_back({static_cast<float>(i), static_cast<float>(-i), 0.5F});
  for (const Cloud& cloud : {three_points(), organised, large}) {
    Cloud ply, pcd;
    scan_cell_common::save_cloud(path("cloud.ply"), cloud);
    ASSERT_EQ(pcl::io::loadPLYFile(path("cloud.ply"), ply), 0);
    scan_cell_common::save_cloud(path("cloud.pcd"), cloud);
    ASSERT_EQ(pcl::io::loadPCDFile(path("cloud.pcd"), pcd), 0);
    ASSERT_EQ(ply.size(), cloud.size());
    ASSERT_EQ(pcd.size(), cloud.size());
    EXPECT_EQ(pcd.height, cloud.height);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      EXPECT_EQ(std::memcmp(ply[i].data, cloud[i].data, 3 * sizeof(float)), 0) << i;
      EXPECT_EQ(std::memcmp(pcd[i].data, cloud[i].data, 3 * sizeof(float)), 0) << i;
    }
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
  EXPECT_THROW(scan_cell_common::load_cloud(write("cloud.las", "0 0 0\n")), FileError);
  EXPECT_THROW(scan_cell_common::load_cloud(
                   write("whole.pcd",
                         "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE I I I\nCOUNT 1 1 1\nWIDTH 1\n"
                         "HEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n")),
               FileError);
  EXPECT_THROW(scan_cell_common::save_cloud(path("no/such/folder/cloud.ply"), three_points()),
               FileError);
  EXPECT_THROW(scan_cell_common::save_cloud(path("cloud.xyz"), three_points()), FileError);
}

namespace {

using scan_cell_common::Error;
using scan_cell_common::parse_obj;
using scan_cell_common::parse_pcd;
using scan_cell_common::parse_ply;
using scan_cell_common::parse_stl;

template <class Parser>
std::string complaint(Parser parse, const std::string& bytes) {
  try {
    parse(bytes, "f");
  } catch (const scan_cell_common::FileError& error) {
    return error.what();
  }
  return "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

std::string ply(const std::string& body, const std::string& count = "2",
                const std::string& more = "") {
  return "ply\nformat ascii 1.0\nelement vertex " + count +
         "\nproperty float x\nproperty float y\nproperty float z\n" + more + "end_header\n" + body;
}

std::string pcd(const std::string& body, const std::string& width = "2",
                const std::string& data = "ascii") {
  return "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + width +
         "\nHEIGHT 1\nDATA " + data + "\n" + body;
}

std::string floats(std::initializer_list<float> values) {
  std::string bytes;
  for (const float value : values)
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  return bytes;
}

std::string with_crlf(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\r');
  return text;
}

}  // namespace

TEST(PlyReader, TakesEveryFormatAndAnyOtherProperties) {
  const std::string header =
      " 1.0\ncomment a\nobj_info b\nelement camera 1\nproperty list uchar double view\n"
      "element vertex 2\nproperty list uchar short tags\nproperty float x\nproperty uchar red\n"
      "property double y\nproperty float z\nelement face 1\nproperty list int int corners\n"
      "end_header\n";
  const std::string ascii =
      "ply\nformat ascii" + header + "2 1 2\n1 9 0.5 255 -2.25 3\n0 1 0 2 3\n2 0 1\n";
  for (const std::string& text : {ascii, with_crlf(ascii), "\xef\xbb\xbf" + ascii}) {
    const Cloud cloud = parse_ply(text, "f");
    ASSERT_EQ(cloud.size(), 2U);
    EXPECT_EQ(cloud[0].getVector3fMap(), Eigen::Vector3f(0.5F, -2.25F, 3));
    EXPECT_EQ(cloud[1].getVector3fMap(), Eigen::Vector3f(1, 2, 3));
  }
  // The same in big endian: 0.5, 1 and 3 as float, 2.25 and 2 as double.
  const std::string big = "ply\nformat binary_big_endian" + header +
                          std::string(
                              "\0"
                              "\1\0\x9\x3f\0\0\0\xff\xc0\x02\0\0\0\0\0\0\x40\x40\0\0"
                              "\0\x3f\x80\0\0\0\x40\0\0\0\0\0\0\0\x40\x40\0\0"
                              "\0\0\0\1\0\0\0\7",
                              47);
  const Cloud cloud = parse_ply(big, "f");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud[0].getVector3fMap(), Eigen::Vector3f(0.5F, -2.25F, 3));
  EXPECT_EQ(cloud[1].getVector3fMap(), Eigen::Vector3f(1, 2, 3));
}

TEST(PlyReader, SaysWhatIsWrong) {
  EXPECT_SAYS(complaint(parse_ply, ""), "f: not a PLY file");
  EXPECT_SAYS(complaint(parse_ply, "\x89PNG\r\n\x1a\n"), "f: not a PLY file");
  EXPECT_SAYS(complaint(parse_ply, "ply\nformat ascii 1.0\n"), "its header has no end");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1\n", "4000000000")),
              "truncated: its header promises 4000000000");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1\n", "99999999999999999999999")),
              "line 3: an element without name and count");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1\n", "-1")),
              "line 3: an element without name and count");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n\n\n\n\n\n\n\n")), "truncated: it has 1 of 2");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1000\n")), "line 9: 2 values");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1 1\n")), "line 9: 4 values");
  EXPECT_SAYS(complaint(parse_ply, ply("0,5 0 0\n1 1 1\n")), "line 8: '0,5'; give a number");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1\n2 2 2\n")), "line 10: more than the header");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0 0\n1 1 1 1\n", "2", "property float x\n")),
              "not have exactly one x");
  EXPECT_SAYS(complaint(parse_ply, ply("", "0", "element vertex 0\n")), "not exactly one element");
  EXPECT_SAYS(complaint(parse_ply, ply("0 0 0\n1 1 1\n", "2",
                                       "element face 1\nproperty list uchar int corners\n")),
              "truncated: its header promises 1 of the element 'face'");
  std::string whole = ply("1 1 1\n0 0 0\n");
  whole.replace(whole.find("float x"), 7, "int x");
  EXPECT_SAYS(complaint(parse_ply, whole), "not have exactly one x as float or double");
}

TEST(PlyReader, SeesAnyByteThatIsMissing) {
  std::string binary =
      ply(floats({0, 0, 0, 1, 1, 1}), "2", "element face 1\nproperty list uchar int corners\n") +
      std::string("\1\7\0\0\0", 5);
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  EXPECT_EQ(parse_ply(binary, "f").size(), 2U);
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_THROW(parse_ply(binary.substr(0, size), "f"), Error) << size;
  EXPECT_SAYS(complaint(parse_ply, binary + "more"), "4 bytes more than its header promises");
}

TEST(PcdReader, SaysWhatIsWrong) {
  EXPECT_EQ(parse_pcd(with_crlf(pcd("0 0 0\n1 nan 1\n")), "f").size(), 2U);
  EXPECT_SAYS(complaint(parse_pcd, ""), "not a PCD file");
  EXPECT_SAYS(complaint(parse_pcd, "\x89PNG\r\n"), "in the header of a PCD file");
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n", "1000000000", data)), "truncated");
    EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n", "2147483647", data)), "truncated");
    EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n", "1e9", data)), "line 6: '1e9'");
    EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n", "-1", data)), "line 6: '-1'");
  }
  EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n")), "truncated");
  EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1000\n")), "line 10: 2 values");
  EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n2 2 2\n")), "more than the header promises");
  EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n0,5 1 1\n")), "line 10: '0,5'; give a number");
  EXPECT_SAYS(complaint(parse_pcd, pcd("0 0 0\n1 1 1\n", "2", "zipped")), "DATA 'zipped'");
  std::string more = pcd("0 0 0\n1 1 1\n");
  more.insert(more.find("DATA"), "POINTS 3\n");
  EXPECT_SAYS(complaint(parse_pcd, more), "3 points in 2 x 1");
  std::string large = pcd("0 0 0\n1 1 1\n");
  large.replace(large.find("SIZE 4"), 6, "SIZE 9");
  EXPECT_SAYS(complaint(parse_pcd, large), "line 3: '9'");
  std::string twice = pcd("0 0 0\n1 1 1\n");
  twice.replace(twice.find("x y z"), 5, "x y x");
  EXPECT_SAYS(complaint(parse_pcd, twice), "not exactly one x, y and z");
}

TEST(PcdReader, SeesAnyByteThatIsMissing) {
  const std::string binary = pcd(floats({0, 0, 0, 1, 1, 1}), "2", "binary");
  EXPECT_EQ(parse_pcd(binary, "f").size(), 2U);
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_THROW(parse_pcd(binary.substr(0, size), "f"), Error) << size;
  EXPECT_SAYS(complaint(parse_pcd, binary + "more"), "4 bytes more than its header promises");
}

TEST_F(CloudFiles, OfPclAreReadAsPclWroteThem) {
  Cloud cloud;
  cloud.width = 40;
  cloud.height = 25;
  for (int i = 0; i < 1000; ++i) {
    cloud.points.emplace_back(0.001F * static_cast<float>(i % 40),
                              0.001F * static_cast<float>(i / 40), i % 7 == 0 ? NAN : 0.25F);
  }
  pcl::PCDWriter().writeASCII(path("a.pcd"), cloud);
  pcl::PCDWriter().writeBinary(path("b.pcd"), cloud);
  pcl::PCDWriter().writeBinaryCompressed(path("c.pcd"), cloud);
  pcl::PLYWriter().write(path("d.ply"), cloud, false, true);
  pcl::PLYWriter().write(path("e.ply"), cloud, true, true);
  for (const char* name : {"a.pcd", "b.pcd", "c.pcd", "d.ply", "e.ply"}) {
    SCOPED_TRACE(name);
    const Cloud read = scan_cell_common::load_cloud(path(name));
    ASSERT_EQ(read.size(), 1000U);
    EXPECT_FALSE(read.is_dense);
    const bool is_pcd = std::string(name).find("pcd") != std::string::npos;
    EXPECT_EQ(read.height, is_pcd ? 25U : 1U);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_EQ(read[i].x, cloud[i].x);
      ASSERT_EQ(read[i].y, cloud[i].y);
      ASSERT_EQ(std::isnan(read[i].z), std::isnan(cloud[i].z));
      if (i % 7 != 0) {
        ASSERT_EQ(read[i].z, cloud[i].z);
      }
    }
  }
}

TEST(PcdReader, DoesNotTrustTheSizesOfPackedPoints) {
  const auto packed = [](std::uint32_t packed_size, std::uint32_t size, const std::string& width,
                         const std::string& bytes) {
    std::string sizes(8, '\0');
    std::memcpy(&sizes[0], &packed_size, 4);
    std::memcpy(&sizes[4], &size, 4);
    return complaint(parse_pcd, pcd(sizes + bytes, width, "binary_compressed"));
  };
  const std::string bytes(27, '\x20');
  EXPECT_SAYS(packed(27, 4000000000U, "333333333", bytes), "contradict");
  EXPECT_SAYS(packed(4000000000U, 24, "2", bytes), "contradict");
  EXPECT_SAYS(packed(0, 24, "2", bytes), "contradict");
  EXPECT_SAYS(packed(27, 25, "2", bytes), "contradict");
  EXPECT_SAYS(packed(27, 24, "2", bytes), "compressed points are corrupt");
  EXPECT_SAYS(packed(27, 8, "1431655766", bytes), "truncated");  // 8 in 32 bits
}

TEST(MeshReaders, SayWhatIsWrong) {
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid a\n";
  EXPECT_EQ(parse_stl(with_crlf(stl), "f").polygons.size(), 1U);
  EXPECT_SAYS(complaint(parse_stl, stl.substr(0, stl.find("endsolid"))), "truncated");
  EXPECT_SAYS(complaint(parse_stl, stl.substr(0, stl.find("endloop"))), "truncated");
  EXPECT_SAYS(complaint(parse_stl, "hello"), "not an STL file");
  std::string lost = stl;
  lost.erase(lost.find("vertex 1"), 13);
  EXPECT_SAYS(complaint(parse_stl, lost), "line 7: 'endfacet' out of place");
  std::string binary(84 + 100, ' ');
  std::memcpy(&binary[80], "\2\0\0", 4);
  EXPECT_EQ(parse_stl(binary, "f").polygons.size(), 2U);
  EXPECT_SAYS(complaint(parse_stl, binary.substr(0, 150)), "truncated: it has 150 of 184 bytes");
  binary[83] = '\x7f';
  EXPECT_SAYS(complaint(parse_stl, binary), "truncated: it has 184 of");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1\n"), "line 3: truncated");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"), "line 4: a face with 2");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "vertex 4 of 3");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"), "vertex '-4'");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nf 1 2 0\n"), "vertex '0'");
  EXPECT_SAYS(complaint(parse_obj, "v 0 0 0\nf 1 2 99999999999\n"), "vertex '99999999999'");
  EXPECT_EQ(parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1/2/3 2//1 4 3\n", "f")
                .polygons[0]
                .vertices.size(),
            4U);
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
