// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "path_design/designed_path.h"
#include "path_design/path_checks.h"
#include "path_design/shapes.h"
#include "tool_path_stretcher/stretcher.h"

using namespace part_recipes;
using namespace path_checks;
using Eigen::Vector3d;
using tool_path_stretcher::surface_from_cloud;

namespace {

/// Adapts a path to the same panel, moved and scanned anew.
void expect_adapted(const tool_paths::ToolPath& path) {
  const tool_path_stretcher::StretchParameters parameters;
  const shapes::Soup panel = shapes::panel(120);
  Eigen::Isometry3d motion(Eigen::Translation3d(0.4, -0.2, 0.1));
  motion.rotate(Eigen::AngleAxisd(0.7, Vector3d(0.1, -0.2, 1).normalized()));
  const auto reference =
      surface_from_cloud(shapes::cloud_of(panel, 0.001, 0.00003, 11), parameters.leaf, "reference");
  const auto object = surface_from_cloud(
      shapes::cloud_of(shapes::moved(panel, motion), 0.001, 0.00003, 5), parameters.leaf, "object");
  const auto result = tool_path_stretcher::stretch(reference, object, path, parameters);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const auto made = all(path), adapted = all(result.path);
  ASSERT_EQ(made.size(), adapted.size());
  for (std::size_t i = 0; i < made.size(); ++i)
    EXPECT_LT((motion * position(made[i]) - position(adapted[i])).norm(), 0.0005);
}

}  // namespace

TEST(StretchedPaths, FromSlicesAreAccepted) {
  SliceParameters parameters;
  parameters.spacing = 0.02;
  parameters.margin = 0.005;
  parameters.border_passes = 1;
  expect_adapted(path_from_slices(shapes::mesh_of(shapes::panel(120)), parameters).path);
}

TEST(StretchedPaths, FromEdgesAreAccepted) {
  EdgeParameters parameters;
  parameters.offset = 0.006;
  expect_adapted(path_from_edge(shapes::mesh_of(shapes::panel(120)), parameters).path);
}

TEST(StretchedPaths, FromPicksOnACloudAreAccepted) {
  const auto sheet = shapes::sheet_of(shapes::cloud_of(shapes::panel(120), 0.001, 0.00003, 11));
  PickParameters parameters;
  parameters.max_distance = 0.03;
  expect_adapted(
      path_from_picks(sheet, {{-0.1, -0.05, 0}, {0, 0.05, 0}, {0.03, -0.04, 0}}, parameters).path);
}
