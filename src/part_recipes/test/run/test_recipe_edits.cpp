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

TEST_F(RecipeEdits, AreRefusedByLineAndLeaveTheRecipeAsItIs) {
  const Recipe recipe = make();
  const std::string before = read_file((recipe.folder / recipe.cleaning).string());
  EXPECT_THROW(set_edits(recipe, "edits:\n  - delete: {sphere: {}}\n"),
               scan_cell_common::UnusableInput);
  EXPECT_THROW(set_edits(recipe, "hello"), scan_cell_common::UnusableInput);
  EXPECT_EQ(read_file((recipe.folder / recipe.cleaning).string()), before);
}

TEST_F(RecipeEdits, DoNotHideThatAnotherFileWasChanged) {
  const Recipe recipe = make();
  scan_cell_common::save_text((recipe.folder / recipe.path.file).string(), "x,y,z\n1,2,3\n");
  EXPECT_THROW(set_edits(recipe, kBox), scan_cell_common::Refused);
}

}  // namespace
}  // namespace part_recipes
