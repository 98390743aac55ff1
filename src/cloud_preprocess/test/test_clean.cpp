// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "clean_cloud_tool.h"
#include "cloud_preprocess/clean.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scene.h"

namespace fs = std::filesystem;
using cloud_preprocess::clean;
using cloud_preprocess::CleanCloudTool;
using cloud_preprocess::CleanParameters;
using cloud_preprocess::Cloud;
using cloud_preprocess::Label;
using cloud_preprocess::raw_scan;
using cloud_preprocess::Scene;
using cloud_preprocess::StageReport;
using cloud_preprocess::TracedCloud;

namespace {

CleanParameters parse(const std::string& text) {
  return cloud_preprocess::read_clean_parameters({YAML::Load(text), "clean.yaml"});
}

std::string complaint(const std::string& text) {
  try {
    parse(text);
  } catch (const scan_cell_common::Error& error) {
    return error.what();
  }
  return "nothing";
}

}  // namespace

TEST(Clean, LeavesOneObjectOfARawScan) {
  const Scene scene = raw_scan();
  CleanParameters parameters;
  parameters.grid.reset();
  std::vector<StageReport> reports;
  const Cloud left = clean(scene.cloud(), parameters, reports);
  EXPECT_GE(scene.share_in(left, Label::kPart), 0.9999);
  EXPECT_EQ(scene.share_in(left, Label::kFloor), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kOtherPart), 0.0);
  EXPECT_EQ(scene.share_in(left, Label::kOutlier), 0.0);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0].points_in, scene.cloud().size());
  EXPECT_EQ(reports[1].points_in, reports[0].points_out);
  EXPECT_EQ(reports[2].points_out, left.size());
}

TEST(Clean, KeepsTheReportsUpToTheStageThatFails) {
  CleanParameters parameters;
  parameters.isolate.limits.x_min = 5;
  std::vector<StageReport> reports;
  EXPECT_THROW(clean(raw_scan().cloud(), parameters, reports), scan_cell_common::UnusableInput);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports.back().stage, "isolate");
  EXPECT_GT(reports.back().points_in, 0U);
  EXPECT_EQ(reports.back().points_out, 0U);
}

TEST(Clean, LeavesEachObjectOfARawScan) {
  const Scene scene = raw_scan();
  CleanParameters parameters;
  parameters.grid.reset();
  std::vector<StageReport> reports;
  TracedCloud cloud(scene.cloud());
  std::vector<TracedCloud> objects;
  clean(cloud, parameters, reports, objects);
  ASSERT_EQ(objects.size(), 2U);  // along x: the frame, the box
  EXPECT_GE(scene.share_in(objects[0].cloud(), Label::kPart), 0.9999);
  EXPECT_EQ(scene.share_in(objects[0].cloud(), Label::kOtherPart), 0.0);
  EXPECT_GE(scene.share_in(objects[1].cloud(), Label::kOtherPart), 0.99);
  EXPECT_EQ(scene.share_in(objects[1].cloud(), Label::kPart), 0.0);
  EXPECT_EQ(objects[0].sources(), cloud.sources());  // the larger one is the requested one
}

TEST(CleanParameters, AreTheDefaultsInTheShippedFile) {
  const CleanParameters shipped = cloud_preprocess::load_clean_parameters(SHIPPED_CONFIG);
  const CleanParameters defaults;
  EXPECT_EQ(shipped.floor.automatic, defaults.floor.automatic);
  EXPECT_EQ(shipped.floor.margin, defaults.floor.margin);
  EXPECT_EQ(shipped.floor.distance, defaults.floor.distance);
  EXPECT_EQ(shipped.floor.up, defaults.floor.up);
  EXPECT_EQ(shipped.floor.any_direction, defaults.floor.any_direction);
  EXPECT_EQ(shipped.floor.tilt, defaults.floor.tilt);
  EXPECT_EQ(shipped.floor.min_share, defaults.floor.min_share);
  EXPECT_EQ(shipped.floor.max_below, defaults.floor.max_below);
  EXPECT_EQ(shipped.outliers.neighbours, defaults.outliers.neighbours);
  EXPECT_EQ(shipped.outliers.deviations, defaults.outliers.deviations);
  EXPECT_EQ(shipped.isolate.select, defaults.isolate.select);
  EXPECT_EQ(shipped.isolate.gap, defaults.isolate.gap);
  EXPECT_EQ(shipped.isolate.across_shadows, defaults.isolate.across_shadows);
  EXPECT_EQ(shipped.isolate.min_points, defaults.isolate.min_points);
  EXPECT_EQ(shipped.grid->leaf, defaults.grid->leaf);
}

TEST(CleanParameters, AreReadFromYaml) {
  const CleanParameters parameters = parse(
      "{floor: {automatic: false, z_min: 0.01}, isolate: {select: index, index: 2, axis: y}, "
      "grid: off}");
  EXPECT_FALSE(parameters.floor.automatic);
  EXPECT_EQ(parameters.floor.limits.z_min, 0.01);
  EXPECT_EQ(parameters.isolate.select, cloud_preprocess::Selection::kIndex);
  EXPECT_EQ(parameters.isolate.index, 2);
  EXPECT_EQ(parameters.isolate.axis, cloud_preprocess::Axis::kY);
  EXPECT_FALSE(parameters.grid.has_value());
}

TEST(CleanParameters, AreRefusedByTheNameOfTheBadEntry) {
  EXPECT_EQ(complaint("floor: {margin: -1}"), "floor.margin: -1; give a value from 0 to 1");
  EXPECT_EQ(complaint("floor: {margin: wide}"),
            "clean.yaml: floor.margin: wrong type (line 1); correct it");
  EXPECT_EQ(complaint("floor: {margn: 1}"),
            "clean.yaml: floor.margn: no such entry (line 1); check its spelling");
  EXPECT_EQ(complaint("flor: {}"), "clean.yaml: flor: no such entry (line 1); check its spelling");
  EXPECT_EQ(complaint("grid: {leaf: [1, 1]}"), "grid.leaf: 2 numbers; give 3");
  EXPECT_EQ(complaint("isolate: {select: best}"),
            "isolate.select: 'best'; give one of all, largest, nearest, index, reference");
  EXPECT_EQ(complaint("outliers: {x_min: 1, x_max: 0}").find("outliers.x_min"), 0U);
}

TEST_F(CleanCloudTool, CleansAFileAndPrintsAStageALine) {
  ASSERT_EQ(run("--input " + path("scan.ply") + " --output " + path("part.ply")), 0) << printed();
  const Cloud left = scan_cell_common::load_cloud(path("part.ply"));
  std::vector<StageReport> reports;
  EXPECT_EQ(left.size(), clean(raw_scan().cloud(), {}, reports).size());
  for (const char* stage : {"floor ", "outliers ", "isolate ", "grid "}) {
    EXPECT_NE(printed().find(stage), std::string::npos) << printed();
  }
}

TEST_F(CleanCloudTool, WritesEachObjectAsAFileOfItsOwn) {
  const std::string files = "--input " + path("scan.ply") + " --output " + path("part.ply");
  std::ofstream(path("all_0.ply")) << "of an earlier run";
  std::ofstream(path("all_1.ply")) << "of an earlier run";
  std::ofstream(path("all_2.ply")) << "of an earlier run";
  ASSERT_EQ(run(files + " --objects " + path("all.ply")), 0) << printed();
  EXPECT_EQ(scan_cell_common::load_cloud(path("all_0.ply")).size(),
            scan_cell_common::load_cloud(path("part.ply")).size());
  EXPECT_GT(scan_cell_common::load_cloud(path("all_1.ply")).size(), 200U);
  EXPECT_FALSE(fs::exists(path("all_2.ply")));
}

TEST_F(CleanCloudTool, RunsEachStageAlone) {
  const std::string files = "--input " + path("scan.ply") + " --output " + path("part.ply");
  const std::string off = " --floor off --outliers off --isolate off --grid off";
  ASSERT_EQ(run(files + off), 0) << printed();
  EXPECT_EQ(scan_cell_common::load_cloud(path("part.ply")).size(), raw_scan().cloud().size());
  ASSERT_EQ(run(files + " --floor off --outliers off --isolate off --grid 4,4,2"), 0) << printed();
  const std::size_t coarse = scan_cell_common::load_cloud(path("part.ply")).size();
  EXPECT_LT(coarse, raw_scan().cloud().size() / 10);
  ASSERT_EQ(run(files + off + " --z-min 0.01 --z-max 0.02 --x-max 0 --set isolate.y_min=0"), 0);
  for (const pcl::PointXYZ& point : scan_cell_common::load_cloud(path("part.ply"))) {
    EXPECT_TRUE(point.z >= 0.01 && point.z <= 0.02 && point.x <= 0 && point.y >= 0);
  }
}

TEST_F(CleanCloudTool, WritesNothingAndSaysWhyWhereItFails) {
  const std::string files = "--input " + path("scan.ply") + " --output " + path("part.ply");
  EXPECT_EQ(run(files + " --z-min 70"), 1);
  EXPECT_NE(printed().find("floor: limits: no point lies within them"), std::string::npos)
      << printed();
  EXPECT_EQ(run(files + " --grid 2,2"), 1);
  EXPECT_NE(printed().find("grid.leaf"), std::string::npos) << printed();
  EXPECT_EQ(run(files + " --grid wide"), 1);
  EXPECT_EQ(run(files + " --floor maybe"), 1);
  EXPECT_EQ(run("--input " + path("none.ply") + " --output " + path("part.ply")), 1);
  EXPECT_NE(printed().find("none.ply"), std::string::npos) << printed();
  EXPECT_FALSE(fs::exists(path("part.ply")));
}
