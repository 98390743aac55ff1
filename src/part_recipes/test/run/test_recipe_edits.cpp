// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_preprocess/clean.h"
#include "made_up_recipe.h"
#include "recipe/proof.h"
#include "recipe/recipe_edits.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using scan_cell_common::read_file;

constexpr const char* kBox =
    "edits:\n  - delete: {box: {center: [1, 2, 3], size: [0.1, 0.2, 0.3]}}\n";

class RecipeEdits : public MadeUpRecipe {
 protected:
  static std::size_t edits_of(const Recipe& recipe) {
    return cloud_preprocess::load_clean_parameters((recipe.folder / recipe.cleaning).string())
        .edits.size();
  }
};

TEST_F(RecipeEdits, TakeThePlaceOfThoseThatWereThereAndLeaveTheRestAsItWasWritten) {
  const Recipe recipe = make();
  const std::string before = read_file((recipe.folder / recipe.cleaning).string());
  set_edits(recipe, kBox);
  EXPECT_EQ(edits_of(recipe), 1u);
  set_edits(recipe, kBox);
  EXPECT_EQ(edits_of(recipe), 1u);
  const std::string after = read_file((recipe.folder / recipe.cleaning).string());
  EXPECT_EQ(after.substr(0, before.size()), before);
  set_edits(recipe, "");
  EXPECT_EQ(read_file((recipe.folder / recipe.cleaning).string()), before);
}

TEST_F(RecipeEdits, MakeTheRecipeAnewAndNotProven) {
  const Recipe recipe = make();
  Proof proof = load_proof(recipe);
  proof.proven = true;
  save_proof(recipe, proof);
  set_edits(recipe, kBox);
  const Proof now = load_proof(recipe);
  EXPECT_FALSE(now.proven);
  EXPECT_EQ(now.calibration, proof.calibration);
  EXPECT_NO_THROW(check_unchanged(recipe, now, hashes_of(recipe)));
}

TEST_F(RecipeEdits, GiveSettingsToARecipeThatHadNone) {
  made_.cleaning.clear();
  const Recipe recipe = make();
  set_edits(recipe, kBox);
  const Recipe now = load_recipe(recipe.folder);
  EXPECT_EQ(now.cleaning, "cleaning.yaml");
  EXPECT_EQ(edits_of(now), 1u);
  EXPECT_NO_THROW(check_unchanged(now, load_proof(now), hashes_of(now)));
}

/// A program of one line along x, with this speed.
scan_cell::ScanProgram one_line(double speed) {
  scan_cell::ScanPass pass;
  pass.poses.assign(2, Eigen::Isometry3d::Identity());
  pass.poses[1].translation().x() = 0.2;
  pass.speed = speed;
  pass.rate = 50;
  return {"world", {pass}};
}

TEST_F(RecipeEdits, PutAnotherScanProgramInPlaceOfTheOneThatWasThere) {
  const std::string file = (folder_.path() / "program.yaml").string();
  save_scan_program(file, one_line(0.05));
  made_.program = file;
  const Recipe recipe = make();
  Proof proof = load_proof(recipe);
  proof.proven = true;
  save_proof(recipe, proof);
  scan_cell::ScanProgram moved = one_line(0.04);
  moved.passes[0].poses[1].translate(Eigen::Vector3d(0, 0.01, 0));
  set_program(recipe, moved);
  const auto now = scan_cell::load_scan_program((recipe.folder / recipe.program).string());
  EXPECT_EQ(now.passes.at(0).speed, 0.04);
  EXPECT_TRUE(now.passes[0].poses[1].isApprox(moved.passes[0].poses[1], 1e-12));
  EXPECT_FALSE(load_proof(recipe).proven);
  EXPECT_NO_THROW(check_unchanged(recipe, load_proof(recipe), hashes_of(recipe)));
  const std::string before = read_file((recipe.folder / recipe.program).string());
  EXPECT_THROW(set_program(recipe, one_line(-1)), scan_cell_common::Refused);
  EXPECT_EQ(read_file((recipe.folder / recipe.program).string()), before);
}

TEST_F(RecipeEdits, GiveNoProgramToARecipeThatHasNone) {
  EXPECT_THROW(set_program(make(), one_line(0.05)), scan_cell_common::Refused);
}

TEST_F(RecipeEdits, AreRefusedByLineAndLeaveTheRecipeAsItIs) {
  const Recipe recipe = make();
  const std::string before = read_file((recipe.folder / recipe.cleaning).string());
  EXPECT_THROW(set_edits(recipe, "edits:\n  - delete: {sphere: {}}\n"),
               scan_cell_common::UnusableInput);
  EXPECT_THROW(set_edits(recipe, "hello"), scan_cell_common::UnusableInput);
  EXPECT_EQ(read_file((recipe.folder / recipe.cleaning).string()), before);
}

TEST_F(RecipeEdits, MayBeAllThatThereWas) {
  made_.cleaning.clear();
  const Recipe recipe = make();
  set_edits(recipe, kBox);
  const Recipe now = load_recipe(recipe.folder);
  set_edits(now, "");
  EXPECT_EQ(edits_of(now), 0u);
}

TEST_F(RecipeEdits, AreApartFromTheStages) {
  const Recipe recipe = make();
  const std::string path = (recipe.folder / recipe.cleaning).string();
  scan_cell_common::save_text(path,
                              "# of the press shop\ngrid: {leaf: [0.001, 0.001, 0.001]}\nfloor:\n"
                              "  margin: 0.003  # it is rough\n# and not level:\n  tilt: 0.1\n"
                              "\n# two clamps\noutliers: {neighbours: 20}\n");
  save_proof(recipe, {true, "", "", hashes_of(recipe), load_proof(recipe).calibration});
  set_edits(recipe, kBox);
  set_stages(recipe, "{floor: {margin: 0.0041}, outliers: {neighbours: 20}}");
  const std::string after = scan_cell_common::read_file(path);
  const auto now = cloud_preprocess::load_clean_parameters(path);
  EXPECT_EQ(now.floor.margin, 0.0041);
  EXPECT_EQ(now.floor.tilt, cloud_preprocess::FloorParameters().tilt);
  EXPECT_EQ(now.outliers.neighbours, 20);
  EXPECT_EQ(now.grid->leaf.x(), 0.001);
  EXPECT_EQ(edits_of(recipe), 1u);
  EXPECT_NE(after.find("# of the press shop\n"), std::string::npos) << after;
  EXPECT_NE(after.find("# two clamps\noutliers: {neighbours: 20}\n"), std::string::npos) << after;
  EXPECT_FALSE(load_proof(recipe).proven);
}

TEST_F(RecipeEdits, AreRefusedWhereTheTextCannotBeChanged) {
  const Recipe recipe = make();
  const std::string path = (recipe.folder / recipe.cleaning).string();
  const std::string before =
      "\"edits\":\n  - delete: {plane: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
      "\"floor\": {margin: 0.003}\n";
  scan_cell_common::save_text(path, before);
  save_proof(recipe, {true, "", "", hashes_of(recipe), load_proof(recipe).calibration});
  EXPECT_THROW(set_edits(recipe, kBox), scan_cell_common::UnusableInput);
  EXPECT_THROW(set_stages(recipe, "{floor: {margin: 0.1}}"), scan_cell_common::UnusableInput);
  EXPECT_EQ(read_file(path), before);
  set_stages(recipe, "{floor: {margin: 0.003}}");
  EXPECT_TRUE(load_proof(recipe).proven) << "nothing was changed";
}

TEST_F(RecipeEdits, OfStagesAreRefusedWhereTheyMakeNoSense) {
  const Recipe recipe = make();
  const std::string path = (recipe.folder / recipe.cleaning).string();
  const std::string before = read_file(path);
  EXPECT_THROW(set_stages(recipe, "{floor: {margin: -1}}"), scan_cell_common::InvalidParameter);
  EXPECT_THROW(set_stages(recipe, "{grid: off}"), scan_cell_common::UnusableInput);
  EXPECT_THROW(set_stages(recipe, ""), scan_cell_common::UnusableInput);
  EXPECT_EQ(read_file(path), before);
}

TEST_F(RecipeEdits, DoNotHideThatAnotherFileWasChanged) {
  const Recipe recipe = make();
  scan_cell_common::save_text((recipe.folder / recipe.path.file).string(), "x,y,z\n1,2,3\n");
  EXPECT_THROW(set_edits(recipe, kBox), scan_cell_common::Refused);
}

}  // namespace
}  // namespace part_recipes
