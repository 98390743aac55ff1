// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "made_up_recipe.h"
#include "run/again.h"
#include "run/calls/recipe_reading.h"
#include "run/report/cleaned_away.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using tool_path_stretcher::Points;

/// A square about the origin, its points 1 mm apart.
Points square() {
  Points points;
  for (int x = -20; x <= 20; ++x)
    for (int y = -20; y <= 20; ++y)
      points.emplace_back(x * 1e-3, y * 1e-3, 0);
  return points;
}

TEST(CleanedAway, CountsWhereTheScanHasPointsAndTheCleanCloudHasNone) {
  const Points places = {{-0.015, 0, 0}, {0.015, 0, 0}, {0.015, 0, 0.02}, {0.1, 0, 0}};
  Points raw = square();
  raw.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  Points clean;
  for (const Eigen::Vector3d& point : square())
    if (point.x() < 0) clean.push_back(point);
  EXPECT_EQ(cleaned_away(places, raw, clean, 0.002), std::vector<std::size_t>{1});
  EXPECT_TRUE(cleaned_away(places, raw, square(), 0.002).empty());
  EXPECT_TRUE(cleaned_away(places, clean, clean, 0.002).empty()) << "it was not scanned";
  EXPECT_TRUE(cleaned_away({}, raw, clean, 0.002).empty());
}

TEST(CleanedAway, TakesNoThinnedCloudForABareOne) {
  const Points places = {{0.0025, 0.0025, 0}};
  Points thin;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      thin.emplace_back(x * 5e-3, y * 5e-3, 0);
  EXPECT_TRUE(cleaned_away(places, square(), thin, 0.001).empty());
}

TEST(CleanedAway, CountsBetweenThePointsOfACoarseScan) {
  const Points places = {{0.0155, 0.0005, 0}};  // 0.7 mm from four points
  Points clean;
  for (const Eigen::Vector3d& point : square())
    if (point.x() < 0) clean.push_back(point);
  EXPECT_EQ(cleaned_away(places, square(), clean, 0.0002), std::vector<std::size_t>{0});
  EXPECT_TRUE(cleaned_away(places, square(), square(), 0.0002).empty());
  const Points over = {{0.0155, 0.0005, 0.005}};
  EXPECT_TRUE(cleaned_away(over, square(), clean, 0.0002).empty()) << "5 mm off is not there";
}

TEST(StretchGiven, IsWhatTheRecipeGivesElseTheDefault) {
  Recipe recipe;
  recipe.stretch = {{"tolerance", "0.0015"}, {"min_points", "300"}, {"method", "affine"}};
  const auto parameters = stretch_parameters_of(recipe);
  EXPECT_EQ(parameters.tolerance, 0.0015);
  EXPECT_EQ(parameters.min_points, 300);
  EXPECT_EQ(parameters.method, tool_path_stretcher::Method::kAffine);
  EXPECT_EQ(parameters.min_overlap, tool_path_stretcher::StretchParameters().min_overlap);
  recipe.stretch = {{"tolerance", "2 mm"}};
  EXPECT_THROW(stretch_parameters_of(recipe), scan_cell_common::InvalidParameter);
  recipe.stretch = {{"tolerance", "-1"}};
  EXPECT_THROW(stretch_parameters_of(recipe), scan_cell_common::InvalidParameter);
}

TEST(StretchGiven, IsReadAsStretchReadsItsCommandLine) {
  Recipe recipe;
  recipe.stretch = {{"min-points", "3e2"}, {"max-position-error", "+1e-4"}, {"units", "mm"}};
  const auto parameters = stretch_parameters_of(recipe);
  EXPECT_EQ(parameters.min_points, 300);
  EXPECT_EQ(parameters.max_position_error, 1e-4);
  recipe.stretch = {{"tolerance", "true"}};  // the option alone
  EXPECT_THROW(stretch_parameters_of(recipe), scan_cell_common::UnusableInput);
}

using ACleanedPart = MadeUpRecipe;

TEST_F(ACleanedPart, ThatLacksItsPathIsToldFromOneThatWasNotScannedThere) {
  // The whole part is scanned; a limit of the floor cuts off 50 mm of its end, and the path with
  // it.
  MadeUpPart::write_cloud(folder_.path() / "whole.ply", Eigen::Isometry3d::Identity());
  scan_cell_common::save_text(made_.cleaning,
                              "floor: {automatic: false, x_max: 0.078}\noutliers: {automatic: "
                              "false}\nisolate: {select: all}\ngrid: false\n");
  const EndedRun run = run_recipe(make(), request("whole.ply"), {});
  ASSERT_EQ(run.record.reason, "path_not_scanned") << run.record.message;
  const auto report = nlohmann::json::parse(text_of(run.folder / "report.json"));
  const std::string words = fmt::format("at {0} of the {0} waypoints the raw scan has points that",
                                        report.at("waypoints_concerned").size());
  EXPECT_NE(run.record.message.find(words), std::string::npos) << run.record.message;
  EXPECT_EQ(report.at("message"), run.record.message);
  EXPECT_EQ(report.at("cleaned_away"), report.at("waypoints_concerned"));
  EXPECT_NE(text_of(run.folder / "report.html").find("look at the cleaning"), std::string::npos);
  EXPECT_EQ(differences(run.folder, run_again(run.folder, folder_.path() / "again", {}).folder),
            std::vector<std::string>());
  // What is left is the scan of another run
  RunRequest cut = request("object.ply");
  cut.scan = run.folder / "object.ply";
  const EndedRun bare = run_recipe(load_recipe(folder_.path() / "recipes" / made_.name), cut, {});
  ASSERT_EQ(bare.record.reason, "path_not_scanned") << bare.record.message;
  EXPECT_EQ(bare.record.message.find("cleaning"), std::string::npos) << bare.record.message;
}

}  // namespace
}  // namespace part_recipes
