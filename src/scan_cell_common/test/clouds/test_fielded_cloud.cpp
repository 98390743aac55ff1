// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <cstring>
#include <fstream>

#include "clouds/scratch_folder.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/errors/errors.h"

using scan_cell_common::Cloud;
using scan_cell_common::FieldedCloud;
using scan_cell_common::FieldType;

namespace {

/// A point with a gap after `laser`, as in scans.
struct Point {
  float x, y, z;
  std::uint8_t laser;
  std::uint8_t gap[3];
  double weight;
};

FieldedCloud three_points_with_fields() {
  const Point points[] = {
      {1, 2, 3, 0, {9, 9, 9}, 0.5}, {4, 5, 6, 1, {9, 9, 9}, 1.0 / 3}, {7, 8, 9, 1, {9, 9, 9}, -7}};
  FieldedCloud cloud;
  cloud.fields = {{"x", FieldType::kFloat32, offsetof(Point, x)},
                  {"y", FieldType::kFloat32, offsetof(Point, y)},
                  {"z", FieldType::kFloat32, offsetof(Point, z)},
                  {"laser", FieldType::kUint8, offsetof(Point, laser)},
                  {"weight", FieldType::kFloat64, offsetof(Point, weight)}};
  cloud.step = sizeof(Point);
  cloud.bytes.resize(sizeof points);
  std::memcpy(cloud.bytes.data(), points, sizeof points);
  return cloud;
}

template <class T>
T value(const pcl::PCLPointCloud2& cloud, std::size_t point, const std::string& name) {
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (field.name != name) continue;
    T result;
    std::memcpy(&result, &cloud.data[point * cloud.point_step + field.offset], sizeof result);
    return result;
  }
  ADD_FAILURE() << name;
  return {};
}

void expect_in_millimetres(const pcl::PCLPointCloud2& read) {
  ASSERT_EQ(read.width * read.height, 3U);
  EXPECT_EQ(value<float>(read, 1, "x"), 4000.0F);
  EXPECT_EQ(value<float>(read, 2, "z"), 9000.0F);
  EXPECT_EQ(value<std::uint8_t>(read, 0, "laser"), 0);
  EXPECT_EQ(value<std::uint8_t>(read, 2, "laser"), 1);
  EXPECT_EQ(value<double>(read, 1, "weight"), 1.0 / 3);
}

class FieldedCloudFile : public ScratchFolder {};

}  // namespace

TEST_F(FieldedCloudFile, IsReadByPclWithAllItsFields) {
  pcl::PCLPointCloud2 read;
  save_cloud((folder_ / "cloud.ply").string(), three_points_with_fields().view(), 1e-3);
  ASSERT_EQ(pcl::io::loadPLYFile((folder_ / "cloud.ply").string(), read), 0);
  expect_in_millimetres(read);
  save_cloud((folder_ / "cloud.pcd").string(), three_points_with_fields().view(), 1e-3);
  ASSERT_EQ(pcl::io::loadPCDFile((folder_ / "cloud.pcd").string(), read), 0);
  expect_in_millimetres(read);
}

TEST_F(FieldedCloudFile, IsReadBackAsPlaces) {
  for (const char* const name : {"cloud.ply", "cloud.pcd"}) {
    save_cloud((folder_ / name).string(), three_points_with_fields().view());
    const Cloud read = scan_cell_common::load_cloud((folder_ / name).string());
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[2].y, 8.0F);
  }
}

TEST(FieldedCloud, GivesOtherPlacesWhatTheirSourcesCarry) {
  Cloud places;
  places.push_back({0.1F, 0.2F, 0.3F});
  places.push_back({0.4F, 0.5F, 0.6F});
  const FieldedCloud chosen = with_fields(places, three_points_with_fields().view(), {2, 0});
  Point points[2];
  ASSERT_EQ(chosen.bytes.size(), sizeof points);
  std::memcpy(points, chosen.bytes.data(), sizeof points);
  EXPECT_EQ(points[0].x, 0.1F);
  EXPECT_EQ(points[1].z, 0.6F);
  EXPECT_EQ(points[0].weight, -7);
  EXPECT_EQ(points[1].laser, 0);
}

TEST(FieldedCloud, TakesPlacesAndDirectionsAlongIntoAnotherFrame) {
  const float point[] = {0, 0, 0, 1, 2, 3, 0, 0, 1};
  FieldedCloud cloud;
  for (const char* const name :
       {"x", "y", "z", "vp_x", "vp_y", "vp_z", "normal_x", "normal_y", "normal_z"}) {
    cloud.fields.push_back({name, FieldType::kFloat32, cloud.step});
    cloud.step += sizeof(float);
  }
  cloud.bytes.resize(sizeof point);
  std::memcpy(cloud.bytes.data(), point, sizeof point);
  Eigen::Isometry3f motion = Eigen::Isometry3f::Identity();
  motion.linear() << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // a quarter turn about y
  motion.translation() = Eigen::Vector3f(10, 20, 30);
  Cloud places;
  places.push_back({10, 20, 30});
  const FieldedCloud moved = with_fields(places, cloud.view(), {0}, motion);
  float values[9];
  ASSERT_EQ(moved.bytes.size(), sizeof values);
  std::memcpy(values, moved.bytes.data(), sizeof values);
  const float expected[] = {10, 20, 30, 13, 22, 29, 1, 0, 0};
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_FLOAT_EQ(values[i], expected[i]) << cloud.fields[i].name;
}

TEST_F(FieldedCloudFile, IsReadBackWithAllItsFields) {
  const FieldedCloud written = three_points_with_fields();
  for (const char* const name : {"cloud.ply", "cloud.pcd"}) {
    const std::string path = (folder_ / name).string();
    save_cloud(path, written.view());
    FieldedCloud read;
    ASSERT_EQ(load_cloud_file(path, {}, read).cloud.size(), 3U);
    ASSERT_EQ(read.fields.size(), 5U) << name;
    EXPECT_EQ(read.fields[3].name, "laser");
    EXPECT_EQ(read.fields[3].type, FieldType::kUint8);
    ASSERT_EQ(read.fields[4].type, FieldType::kFloat64);
    double weight = 0;
    std::memcpy(&weight, &read.bytes[2 * read.step + read.fields[4].offset], sizeof weight);
    EXPECT_EQ(weight, -7) << name;
    EXPECT_EQ(places_of(read.view())[1].z, 6) << name;
  }
}

TEST_F(FieldedCloudFile, LosesWhatThePointsCarryThatAreDropped) {
  const std::string path = (folder_ / "cloud.ply").string();
  std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                         "property short laser\nproperty double y\nproperty float z\n"
                         "property float vp_x\nproperty float vp_y\nproperty float vp_z\n"
                         "property list uchar int others\nend_header\n"
                         "1 -5 2 3 1 1 1 0\n-99 -6 2 3 1 1 1 0\n4 40000 5 6 1 1 9 2 3 4\n";
  scan_cell_common::CloudFormat format;
  format.metres_per_unit = 1e-3;
  format.invalid = {-99};
  FieldedCloud read;
  ASSERT_EQ(load_cloud_file(path, format, read).cloud.size(), 2U);
  ASSERT_EQ(read.size(), 2U);
  ASSERT_EQ(read.fields.size(), 7U) << "without the list";
  const auto at = [&read](std::size_t point, std::size_t field, auto value) {
    std::memcpy(&value, &read.bytes[point * read.step + read.fields[field].offset], sizeof value);
    return value;
  };
  EXPECT_EQ(at(0, 3, std::int16_t{}), -5);
  EXPECT_EQ(at(1, 3, std::int16_t{}), 32767) << "the nearest that the type has";
  EXPECT_FLOAT_EQ(at(1, 6, 0.0F), 0.009F) << "a place in mm";
  EXPECT_FLOAT_EQ(places_of(read.view())[1].y, 0.005F);
}

TEST(FieldedCloud, IsRefusedWhereItsFieldsMakeNoSense) {
  const auto refuses = [](const auto& spoil) {
    FieldedCloud cloud = three_points_with_fields();
    spoil(cloud);
    EXPECT_THROW(places_of(cloud.view()), scan_cell_common::UnusableInput);
  };
  refuses([](FieldedCloud& c) { c.fields.erase(c.fields.begin() + 2); });
  refuses([](FieldedCloud& c) { c.fields[0].type = FieldType::kFloat64; });
  refuses([](FieldedCloud& c) { c.fields[3].type = static_cast<FieldType>(99); });
  refuses([](FieldedCloud& c) { c.fields[4].offset = sizeof(Point) - 4; });
  refuses([](FieldedCloud& c) { c.bytes.pop_back(); });
  refuses([](FieldedCloud& c) { c.step = 0; });
}
