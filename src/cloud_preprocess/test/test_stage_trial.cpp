// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "clean_cloud_tool.h"
#include "cloud_preprocess/stage_trial.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scene.h"

using cloud_preprocess::CleanParameters;
using cloud_preprocess::Cloud;
using cloud_preprocess::Label;
using cloud_preprocess::raw_scan;
using cloud_preprocess::Scene;
using cloud_preprocess::StageReport;
using cloud_preprocess::StageTaking;
using cloud_preprocess::StageTrial;

namespace {

Cloud points_of(const Cloud& cloud, const std::vector<std::uint32_t>& indices) {
  Cloud points;
  for (const std::uint32_t i : indices)
    points.push_back(cloud[i]);
  return points;
}

std::vector<std::vector<std::uint32_t>> points_of(const std::vector<StageTaking>& takings) {
  std::vector<std::vector<std::uint32_t>> points;
  for (const StageTaking& taking : takings)
    points.push_back(taking.points);
  return points;
}

CleanParameters read(const std::string& yaml) {
  return cloud_preprocess::read_clean_parameters({YAML::Load(yaml), "clean.yaml"});
}

}  // namespace

TEST(StageTrial, TellsWhatEachStageOfCleaningTakes) {
  const Scene scene = raw_scan();
  CleanParameters parameters;
  parameters.grid.reset();
  std::vector<StageReport> reports;
  const Cloud left = cloud_preprocess::clean(scene.cloud(), parameters, reports);
  const auto takings = StageTrial(scene.cloud()).run(parameters);
  ASSERT_EQ(takings.size(), 3U);
  std::size_t taken = 0;
  for (std::size_t i = 0; i < takings.size(); ++i) {
    EXPECT_EQ(takings[i].error, "");
    EXPECT_EQ(takings[i].report.stage, reports[i].stage);
    EXPECT_EQ(takings[i].points.size(), reports[i].points_in - reports[i].points_out);
    taken += takings[i].points.size();
  }
  EXPECT_EQ(taken + left.size(), scene.cloud().size());
  EXPECT_EQ(scene.share_in(points_of(scene.cloud(), takings[0].points), Label::kFloor), 1.0);
  EXPECT_GE(scene.share_in(points_of(scene.cloud(), takings[2].points), Label::kOtherPart), 0.99);
}

TEST(StageTrial, TellsTheSameWhateverWasTriedBefore) {
  const Cloud cloud = raw_scan().cloud();
  StageTrial trial(cloud);
  const CleanParameters defaults;
  CleanParameters wide = defaults, loose = defaults;
  wide.floor.margin = 0.004;
  loose.outliers.automatic = false;
  const auto usual = points_of(StageTrial(cloud).run(defaults));
  for (const CleanParameters& parameters : {defaults, wide, loose, wide, defaults}) {
    const auto told = points_of(trial.run(parameters));
    EXPECT_EQ(told, points_of(StageTrial(cloud).run(parameters)));
    EXPECT_EQ(told == usual,
              cloud_preprocess::stages_yaml(parameters) == cloud_preprocess::stages_yaml(defaults));
  }
}

TEST(StageTrial, SaysWhichStageCannotBeDoneAndGoesOnWhenItCan) {
  StageTrial trial(raw_scan().cloud());
  CleanParameters parameters;
  parameters.outliers.limits.x_min = 50;
  const auto takings = trial.run(parameters);
  ASSERT_EQ(takings.size(), 2U);
  EXPECT_FALSE(takings[0].points.empty());
  EXPECT_EQ(takings[1].report.stage, "outliers");
  EXPECT_NE(takings[1].error.find("no point"), std::string::npos) << takings[1].error;
  EXPECT_TRUE(takings[1].points.empty());
  EXPECT_EQ(trial.run({}).size(), 3U);
}

TEST(StagesYaml, HoldsWhatIsNotAsItIsByDefaultToTheLastDigit) {
  CleanParameters parameters;
  EXPECT_EQ(cloud_preprocess::stages_yaml(parameters), "floor: {}\noutliers: {}\nisolate: {}\n");
  parameters.floor.margin = 0.1 / 3;
  parameters.floor.up = {0, 0.6, -0.8};
  parameters.floor.limits.z_min = -0.001;
  parameters.outliers.automatic = false;
  parameters.isolate.select = cloud_preprocess::Selection::kIndex;
  parameters.isolate.index = 2;
  parameters.isolate.reference = "a: b #c.ply";
  const std::string yaml = cloud_preprocess::stages_yaml(parameters);
  const CleanParameters read_back = read(yaml);
  EXPECT_EQ(read_back.floor.margin, parameters.floor.margin);
  EXPECT_EQ(read_back.floor.up, parameters.floor.up);
  EXPECT_EQ(read_back.floor.limits.z_min, parameters.floor.limits.z_min);
  EXPECT_FALSE(read_back.outliers.automatic);
  EXPECT_EQ(read_back.isolate.select, parameters.isolate.select);
  EXPECT_EQ(read_back.isolate.index, 2);
  EXPECT_EQ(read_back.isolate.reference, parameters.isolate.reference);
  EXPECT_EQ(yaml.find("gap"), std::string::npos);
}
