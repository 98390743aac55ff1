// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "design/recipe_path.h"
#include "made_up_recipe.h"
#include "path_design/path_checks.h"
#include "recipe/proof.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {
namespace {

using Eigen::Vector3d;
using scan_cell_common::FileError;
using scan_cell_common::InvalidParameter;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

/// On the flat top of the step, 12 mm high.
const tool_paths::Points kPicks = {{0.085, 0.02, 0.012}, {0.1, 0.04, 0.012}, {0.09, 0.06, 0.012}};

class DesignedRecipePath : public MadeUpRecipe {
 protected:
  static RecipePath through(const Recipe& recipe, const tool_paths::Points& picks,
                            const ToolOptions& options = {}) {
    return RecipePath(recipe, PathWay::kPicks, options, picks, {});
  }

  static void expect_through_picks(const tool_paths::ToolPath& path) {
    for (const Vector3d& pick : kPicks) {
      double least = 1;
      for (const Vector3d& at : path_checks::positions(path))
        least = std::min(least, (at - pick).norm());
      EXPECT_LT(least, 0.001);
    }
    for (const Vector3d& at : path_checks::positions(path))
      EXPECT_NEAR(at.z(), 0.012, 0.0001);
  }
};

TEST_F(DesignedRecipePath, GoesThroughPicksOnItsReference) {
  const Recipe recipe = make();
  const RecipePath made = through(recipe, kPicks, {{"max_step", "0.001"}});
  expect_through_picks(made.path());
  EXPECT_TRUE(made.notes().empty());
}

TEST_F(DesignedRecipePath, TakesPicksInMetresWhateverTheUnitOfTheReference) {
  Recipe recipe = make();
  recipe.reference.units = "inch";  // of the same numbers: 1 there is 25.4 mm
  tool_paths::Points picks = kPicks;
  for (Vector3d& pick : picks)
    pick *= 0.0254;
  const RecipePath made = through(recipe, picks, {{"leaf", "1e-5"}, {"max_step", "0.0001"}});
  for (const Vector3d& at : path_checks::positions(made.path()))
    EXPECT_NEAR(at.z(), 0.012 * 0.0254, 0.0001 * 0.0254);
}

TEST_F(DesignedRecipePath, TakesListsSwitchesAndChoicesAsTheToolDoes) {
  const ToolOptions options = {
      {"tool_x", "0 1 0"}, {"closed", "true"}, {"waypoint_z", "out_of_part"}};
  const auto waypoints = path_checks::all(through(make(), kPicks, options).path());
  EXPECT_LT((waypoints.front().pose.linear().col(0) - Vector3d::UnitY()).norm(), 0.01);
  EXPECT_LT((waypoints.front().pose.linear().col(2) - Vector3d::UnitZ()).norm(), 0.01);
  EXPECT_LT((path_checks::position(waypoints.back()) - kPicks[0]).norm(), 0.011) << "closed";
}

TEST_F(DesignedRecipePath, IsARasterOrAnEdgeLikewise) {
  const Recipe recipe = make();
  EXPECT_GT(waypoint_count(RecipePath(recipe, PathWay::kEdge, {}, {}, {}).path()), 20u);
  const RecipePath raster(recipe, PathWay::kSlices, {{"spacing", "0.01"}}, {}, {});
  EXPECT_GT(waypoint_count(raster.path()), 20u);
}

TEST_F(DesignedRecipePath, SavedIsANewRecipeThatDiffersInItsPathAlone) {
  made_.places = {{"corner", {0.11, 0.07, 0.012}, 0.004}};
  const Recipe recipe = make();
  const Recipe saved = through(recipe, kPicks).save_as(folder_.path() / "recipes", "another");
  expect_through_picks(tool_paths::load_tool_path((saved.folder / saved.path.file).string()));
  EXPECT_FALSE(load_proof(saved).proven);
  EXPECT_EQ(load_proof(saved).calibration, load_proof(recipe).calibration);
  Hashes before = hashes_of(recipe), after = hashes_of(saved);
  for (const char* const changed : {"path.csv", kRecipeFile}) {
    before.erase(changed);
    after.erase(changed);
  }
  EXPECT_EQ(before, after);
  ASSERT_EQ(saved.places.size(), 1u);
  EXPECT_EQ(saved.places[0].position, recipe.places[0].position);
  EXPECT_EQ(saved.programs.size(), recipe.programs.size());
  EXPECT_THROW(through(recipe, kPicks).save_as(folder_.path() / "recipes", "another"), FileError);
}

TEST_F(DesignedRecipePath, IsRefusedAsTheToolRefusesIt) {
  const Recipe recipe = make();
  tool_paths::Points off = kPicks;
  off[1].z() += 0.01;
  EXPECT_EQ(path_checks::thing_of<Refused>([&] { through(recipe, off); }), "pick 2");
  EXPECT_EQ(path_checks::thing_of<UnusableInput>([&] { through(recipe, {kPicks[0]}); }), "picks");
  EXPECT_EQ(path_checks::thing_of<UnusableInput>([&] {
              through(recipe, kPicks, {{"max_step", "-1"}});
            }),
            "--max-step");
}

TEST_F(DesignedRecipePath, TakesNothingIntoTheToolsCommandThatIsNoOptionOfItsWay) {
  const Recipe recipe = make();
  const std::string file = (recipe.folder / kRecipeFile).string();
  const auto thing = [&](const ToolOptions& options) {
    return path_checks::thing_of<InvalidParameter>([&] { through(recipe, kPicks, options); });
  };
  EXPECT_EQ(thing({{"output", file}}), "output");
  EXPECT_EQ(thing({{"max_step", "0.01 --output " + file}}), "max_step");
  EXPECT_EQ(thing({{"closed", "perhaps"}}), "closed");
  EXPECT_EQ(thing({{"help", "true"}}), "help");
  EXPECT_EQ(thing({{"tool_x", " "}}), "tool_x");
  EXPECT_EQ(thing({{"spacing", "0.01"}}), "spacing") << "of another way";
  EXPECT_EQ(path_checks::thing_of<UnusableInput>([&] {
              through(recipe, kPicks, {{"tool_x", "0 1"}});
            }),
            "--tool-x");
  EXPECT_TRUE(std::filesystem::exists(file)) << "the tool removes old outputs";
}

TEST_F(DesignedRecipePath, SavedHasTheSideThatItWasMadeWithInWorkAndPrograms) {
  made_.work = {{"waypoint_z", "out_of_part"}, {"frame", "world"}};
  made_.programs.front().options["waypoint_z"] = "out_of_part";
  const Recipe recipe = make();
  const Recipe saved = through(recipe, kPicks).save_as(folder_.path() / "recipes", "another");
  EXPECT_EQ(saved.work.at("waypoint_z"), "into_part");
  EXPECT_EQ(saved.work.at("frame"), "world");
  EXPECT_EQ(saved.programs.at(0).options.at("waypoint_z"), "into_part");
  const Recipe turned = through(recipe, kPicks, {{"waypoint_z", "out_of_part"}})
                            .save_as(folder_.path() / "recipes", "turned");
  EXPECT_EQ(turned.work.at("waypoint_z"), "out_of_part");
}

TEST(PathOptions, AreToldWithTheirDefaultsAsTheToolTakesThem) {
  const auto option = [](PathWay way, const std::string& name) {
    for (const PathOption& each : options_of(way))
      if (each.name == name) return each;
    return PathOption();
  };
  EXPECT_EQ(option(PathWay::kPicks, "max_step").value, "0.01");
  EXPECT_EQ(option(PathWay::kPicks, "max_step").unit, "m");
  EXPECT_EQ(option(PathWay::kPicks, "from").value, "0 0 1");
  EXPECT_EQ(option(PathWay::kPicks, "closed").words, (std::vector<std::string>{"false", "true"}));
  EXPECT_EQ(option(PathWay::kEdge, "near").value, "");
  EXPECT_EQ(option(PathWay::kSlices, "order").value, "zigzag");
}

}  // namespace
}  // namespace part_recipes
