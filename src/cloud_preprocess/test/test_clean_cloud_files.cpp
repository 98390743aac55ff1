// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/common.h>

#include <cstring>

#include "clean_cloud_tool.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/pose/units.h"

namespace fs = std::filesystem;
using cloud_preprocess::CleanCloudTool;
using cloud_preprocess::Cloud;
using cloud_preprocess::Label;
using cloud_preprocess::Scene;
using scan_cell_common::load_cloud;
using scan_cell_common::metres_per;
using scan_cell_common::save_cloud;

namespace {

const Scene::Rectangle kSmallTable{0, 0, 0.20, 0.15};
const Scene::Rectangle kBoxOnSmallTable{0, 0, 0.06, 0.08};
constexpr double kHeight = 0.03;

Scene table_and_box() {
  Scene scene;
  scene.add_floor(kSmallTable, {kBoxOnSmallTable});
  scene.add_box(kBoxOnSmallTable, kHeight);
  return scene;
}

/// A plate of 30 x 20 mm with a step, 0.1 mm between points.
Cloud small_part() {
  Cloud cloud;
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 200; ++j) {
      const float noise = 1e-6F * static_cast<float>((i * 31 + j * 17) % 23);
      cloud.push_back({1e-4F * static_cast<float>(i), 1e-4F * static_cast<float>(j),
                       (i < 150 ? 0.005F : 0.008F) + noise});
    }
  }
  return cloud;
}

/// Marks each point with its own number: its x in the file's unit.
scan_cell_common::FieldedCloud marked(const Cloud& cloud) {
  scan_cell_common::FieldedCloud result;
  for (const char* const name : {"x", "y", "z", "mark"}) {
    result.fields.push_back({name, scan_cell_common::FieldType::kFloat32, result.step});
    result.step += sizeof(float);
  }
  for (const pcl::PointXYZ& point : cloud) {
    for (const float value : {point.x, point.y, point.z, point.x}) {
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
      result.bytes.insert(result.bytes.end(), bytes, bytes + sizeof value);
    }
  }
  return result;
}

class CleanCloudFiles : public CleanCloudTool {
 protected:
  std::string to_part(const std::string& input, const std::string& output = "part.ply") const {
    return "--input " + path(input) + " --output " + path(output) + " ";
  }

  /// Expects a box of kHeight in that unit, and nothing else.
  void expect_box(const std::string& output, const std::string& unit, int exit_code) const {
    ASSERT_EQ(exit_code, 0) << printed();
    pcl::PointXYZ least, most;
    pcl::getMinMax3D(load_cloud(path(output), metres_per(unit)), least, most);
    EXPECT_NEAR(most.x - least.x, kBoxOnSmallTable.width, 1e-3);
    EXPECT_NEAR(most.y - least.y, kBoxOnSmallTable.depth, 1e-3);
    EXPECT_NEAR(most.z, kHeight, 1e-3);
  }

  void expect_said(const std::string& part) const {
    EXPECT_NE(printed().find(part), std::string::npos) << part << " not in: " << printed();
  }

  void expect_not_said(const std::string& part) const {
    EXPECT_EQ(printed().find(part), std::string::npos) << part << " in: " << printed();
  }
};

}  // namespace

TEST_F(CleanCloudFiles, KeepWhatEachPointCarries) {
  for (const std::string ending : {".ply", ".pcd"}) {
    save_cloud(path("in" + ending), marked(table_and_box().cloud()).view());
    ASSERT_EQ(run(to_part("in" + ending, "out" + ending)), 0) << printed();
    scan_cell_common::FieldedCloud carried;
    const Cloud part = load_cloud_file(path("out" + ending), {}, carried).cloud;
    ASSERT_EQ(carried.fields.size(), 4U) << ending;
    EXPECT_EQ(carried.fields[3].name, "mark");
    ASSERT_GT(part.size(), 100U);
    for (std::size_t i = 0; i < part.size(); ++i) {
      float mark = 0;
      std::memcpy(&mark, &carried.bytes[i * carried.step + 3 * sizeof mark], sizeof mark);
      ASSERT_NEAR(part[i].x, mark, 0.002) << "of a point in the same cell";
    }
  }
}

TEST_F(CleanCloudFiles, AreReadAndWrittenInAnyUnit) {
  for (const std::string unit : {"m", "mm", "inch"}) {
    SCOPED_TRACE(unit);
    save_cloud(path("in.pcd"), table_and_box().cloud(), metres_per(unit));
    expect_box("part.ply", unit, run(to_part("in.pcd") + "--units " + unit));
    expect_box("part.ply", "m", run(to_part("in.pcd") + "--output-units m --units " + unit));
  }
  EXPECT_EQ(run(to_part("in.pcd") + "--units ft"), 1);
}

TEST_F(CleanCloudFiles, InMillimetresAreRefusedByThatName) {
  save_cloud(path("in.ply"), table_and_box().cloud(), metres_per("mm"));
  EXPECT_EQ(run(to_part("in.ply")), 1);
  expect_said("--units mm if it is 19");
  expect_not_said("--units inch");
  EXPECT_FALSE(fs::exists(path("part.ply")));
  save_cloud(path("small.ply"), small_part(), metres_per("mm"));
  EXPECT_EQ(run(to_part("small.ply")), 1);
  expect_said("--units mm if it is 29.");
  EXPECT_EQ(run(to_part("small.ply") + "--units mm --floor off"), 0) << printed();
}

TEST_F(CleanCloudFiles, InInchesAreRefusedByThatName) {
  save_cloud(path("in.ply"), table_and_box().cloud(), metres_per("inch"));
  EXPECT_EQ(run(to_part("in.ply")), 1);
  expect_said("--units inch if it is 19");
}

TEST_F(CleanCloudFiles, InMetresAreNotCalledAnythingElse) {
  Cloud large = small_part();  // 15 x 10 m, 5 cm between points would be, but not with 5 mm
  for (pcl::PointXYZ& point : large)
    point.getVector3fMap() *= 50;
  save_cloud(path("large.ply"), large);
  EXPECT_EQ(run(to_part("large.ply") + "--floor off --outliers off"), 0) << printed();
  save_cloud(path("small.ply"), small_part());
  EXPECT_EQ(run(to_part("small.ply") + "--floor off"), 0) << printed();
  EXPECT_EQ(run(to_part("small.ply") + "--floor off --units mm"), 1);
  expect_said("in mm it is");
  expect_said("--units m if it is");
}

TEST_F(CleanCloudFiles, WithASentinelAreRefusedByItsValueAndTakenWithoutIt) {
  Cloud cloud = table_and_box().cloud();
  for (std::size_t i = 0; i < cloud.size(); i += 7)
    cloud[i].z = -32.768F;
  save_cloud(path("in.ply"), cloud);
  EXPECT_EQ(run(to_part("in.ply")), 1);
  expect_said(std::to_string((cloud.size() + 6) / 7) + " of " + std::to_string(cloud.size()) +
              " points have z -32.768");
  expect_said("--invalid -32.768");
  expect_not_said("--units");
  expect_box("part.ply", "m", run(to_part("in.ply") + "--invalid -32.768"));
  expect_said("hold the invalid number -32.768");
  expect_box("part.ply", "m", run(to_part("in.ply") + "--z-min -1"));
  save_cloud(path("in.ply"), cloud, metres_per("mm"));
  EXPECT_EQ(run(to_part("in.ply") + "--units mm"), 1);
  expect_said("--invalid -32768");
  expect_box("part.ply", "mm", run(to_part("in.ply") + "--units mm --invalid -32768"));
}

TEST_F(CleanCloudFiles, MayBeText) {
  std::ofstream csv(path("in.csv"));
  csv << "x [mm];y [mm];z [mm];intensity\n";
  const Scene scene = table_and_box();
  for (const pcl::PointXYZ& point : scene.cloud())
    csv << 1e3F * point.x << ';' << 1e3F * point.y << ';' << 1e3F * point.z << ";200\n";
  csv.close();
  EXPECT_EQ(run(to_part("in.csv")), 1);
  expect_said("--units mm");
  expect_box("part.ply", "mm", run(to_part("in.csv") + "--units mm"));
  expect_said("column intensity is left out");
}

TEST_F(CleanCloudFiles, MayBeDepthProfiles) {
  std::ofstream csv(path("in.csv"));
  for (int line = 0; line < 150; ++line) {
    for (int column = 0; column < 200; ++column) {
      const bool on_box = line >= 35 && line <= 115 && column >= 70 && column <= 130;
      const bool shadow = !on_box && line >= 31 && line <= 119 && column >= 66 && column <= 134;
      csv << (column > 0 ? "," : "")
          << (shadow ? -99.99 : (on_box ? 30.0 : 0.0) + 0.01 * (line % 3));
    }
    csv << '\n';
  }
  csv.close();
  EXPECT_EQ(run(to_part("in.csv") + "--units mm"), 1);
  expect_said("--column-step");
  expect_box("part.ply", "mm",
             run(to_part("in.csv") + "--units mm --column-step 1 --profile-step 1 --invalid -99.99 "
                                     "--outliers off --grid off"));
  expect_said("150 profiles of 200 columns");
}

TEST_F(CleanCloudFiles, AreNeverWrittenOverTheScan) {
  const auto before = fs::file_size(path("scan.ply"));
  EXPECT_EQ(run(to_part("scan.ply", "scan.ply")), 1);
  expect_said("scan.ply: given twice");
  fs::create_symlink(path("scan.ply"), path("link.ply"));
  EXPECT_EQ(run(to_part("link.ply", "scan.ply")), 1);
  ASSERT_TRUE(fs::exists(path("scan.ply")));
  EXPECT_EQ(fs::file_size(path("scan.ply")), before);
}

TEST_F(CleanCloudFiles, ToWriteAreRefusedByTheirNameBeforeTheWork) {
  EXPECT_EQ(run(to_part("scan.ply", "part.xyz")), 1);
  expect_said("extension '.xyz'; write clouds as .ply or .pcd");
  expect_not_said("floor");  // of the stages' lines
  EXPECT_EQ(run(to_part("scan.ply", "none/part.ply")), 1);
  expect_said("no folder");
  expect_not_said("floor");
}

TEST_F(CleanCloudFiles, MayShowATableInAnyDirection) {
  Scene scene = table_and_box();
  scene.move(
      Eigen::Affine3f(Eigen::AngleAxisf(static_cast<float>(M_PI), Eigen::Vector3f::UnitX())));
  save_cloud(path("in.ply"), scene.cloud());
  EXPECT_EQ(run(to_part("in.ply")), 1);
  expect_said("--up 0.0000,");
  for (const char* up : {"--up 0,0,-1", "--up=-0.1,0.05,-2", "--up auto"}) {
    ASSERT_EQ(run(to_part("in.ply") + "--grid off --outliers off " + up), 0) << up << printed();
    const Cloud left = load_cloud(path("part.ply"));
    EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0) << up;
    EXPECT_EQ(scene.share_in(left, Label::kPart), 1.0) << up;
  }
  EXPECT_EQ(run(to_part("in.ply") + "--up down"), 1);
  expect_said("--up: 'down'; give X,Y,Z, or auto");
  EXPECT_EQ(run(to_part("in.ply") + "--up 0,0,0"), 1);
  expect_said("floor.up");
}
