// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// The whole chain with the suite's own tools, on a made-up part.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "made_up_part.h"
#include "made_up_recipe.h"
#include "recipe/new_recipe.h"
#include "recipe/proof.h"
#include "recipe/recipe_check.h"
#include "run/again.h"
#include "run/prove.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::Refused;

using ARecipe = MadeUpRecipe;

TEST_F(ARecipe, OfAMovedPartGivesPathProgramAndFigures) {
  const EndedRun run = run_recipe(make(), request("moved.ply"), {});
  ASSERT_EQ(run.record.state, RunState::kAccepted) << run.record.message;
  EXPECT_NEAR(*run.record.figures.scale, 1, 1e-3);
  for (const char* name : {"object.ply", "adapted_path.csv", "report.json", "programs/plate.src",
                           "deviation.ply", "inputs/recipe.yaml", "inputs/scan.ply"})
    EXPECT_EQ(run.record.files.count(name), 1u) << name;
  // The truth: the path turned by 30 degrees and shifted.
  const std::string path = text_of(run.folder / "adapted_path.csv");
  double x = 0, y = 0;
  const std::string first = path.substr(path.find('\n') + 1);
  ASSERT_EQ(std::sscanf(first.c_str(), "%lf,%lf", &x, &y), 2);
  const Eigen::Vector3d truth = MadeUpPart::moved() * Eigen::Vector3d(0.09, 0.01, 0);
  EXPECT_NEAR(x, truth.x(), 2e-4);
  EXPECT_NEAR(y, truth.y(), 2e-4);
  EXPECT_NO_THROW(check_files(run.folder, load_run(run.folder)));
  EXPECT_NE(run.warning.find("never proven"), std::string::npos) << run.warning;
}

TEST_F(ARecipe, RunAgainGivesTheSameBytes) {
  const EndedRun run = run_recipe(make(), request("moved.ply"), {});
  const EndedRun again = run_again(run.folder, folder_.path() / "elsewhere", {});
  EXPECT_EQ(again.record.again_of, run.record.id);
  EXPECT_EQ(again.record.state, run.record.state);
  EXPECT_EQ(differences(run.folder, again.folder), std::vector<std::string>());
  scan_cell_common::save_text((run.folder / "inputs/path.csv").string(), "x,y,z\n0,0,0\n");
  EXPECT_THROW(run_again(run.folder, folder_.path() / "elsewhere", {}),
               scan_cell_common::UnusableInput);
}

TEST_F(ARecipe, APathEditedByHandIsARunOfItsOwn) {
  const EndedRun run = run_recipe(make(), request("moved.ply"), {});
  const fs::path runs = folder_.path() / "runs";
  const EndedRun edited =
      run_edited(run.folder, {tool_paths::DeleteEdit{{0, 3}}}, runs, "clamp there", {});
  ASSERT_EQ(edited.record.state, RunState::kAccepted) << edited.record.message;
  EXPECT_EQ(edited.record.path_edits, 1u);
  EXPECT_EQ(edited.record.again_of, run.record.id);
  EXPECT_EQ(edited.record.note, "clamp there");
  EXPECT_EQ(edited.record.recipe_folder, run.record.recipe_folder);
  EXPECT_EQ(text_of(edited.folder / "unedited/adapted_path.csv"),
            text_of(run.folder / "adapted_path.csv"));
  const std::string program = text_of(edited.folder / "programs/plate.src");
  EXPECT_NE(program.find("edited by hand: waypoints 0 to 3 deleted"), std::string::npos);
  EXPECT_NE(text_of(edited.folder / "report.html").find("waypoints 0 to 3 deleted"),
            std::string::npos);
  EXPECT_NO_THROW(check_files(edited.folder, load_run(edited.folder)));
  // More edits follow the earlier ones; repeating the run gives the same
  const EndedRun more = run_edited(edited.folder, {tool_paths::DeleteEdit{{0, 0}}}, runs, "", {});
  EXPECT_EQ(load_run(more.folder).path_edits, 2u);
  EXPECT_EQ(more.record.note, "clamp there");
  EXPECT_EQ(differences(more.folder, run_again(more.folder, runs, {}).folder),
            std::vector<std::string>());
  // Edits for which the path has no place are reported, and nothing is worked
  const EndedRun wrong = run_edited(run.folder, {tool_paths::DeleteEdit{{500, 500}}}, runs, "", {});
  EXPECT_EQ(wrong.record.state, RunState::kRefused);
  EXPECT_NE(wrong.record.message.find("no waypoint 500"), std::string::npos);
  EXPECT_FALSE(fs::exists(wrong.folder / "adapted_path.csv"));
  EXPECT_THROW(run_edited(wrong.folder, {tool_paths::DeleteEdit{{0, 0}}}, runs, "", {}), Refused);
}

TEST_F(ARecipe, OfAnotherPartIsARunThatWasRefused) {
  Eigen::Isometry3d mirrored = Eigen::Isometry3d::Identity();
  mirrored.matrix()(0, 0) = -1;
  MadeUpPart::write_cloud(folder_.path() / "other.ply", mirrored);
  const EndedRun run = run_recipe(make(), request("other.ply"), {});
  EXPECT_EQ(run.record.state, RunState::kRefused) << run.record.message;
  EXPECT_NE(run.record.reason, "accepted");
  EXPECT_FALSE(fs::exists(run.folder / "adapted_path.csv"));
  EXPECT_FALSE(fs::exists(run.folder / "programs"));
}

TEST_F(ARecipe, WithAScanOfNoUseIsARunThatSaysSo) {
  scan_cell_common::save_text((folder_.path() / "broken.ply").string(), "ply\nno more\n");
  const EndedRun run = run_recipe(make(), request("broken.ply"), {});
  EXPECT_EQ(run.record.state, RunState::kUnusable);
  EXPECT_EQ(run.record.reason, "clean_failed");
  EXPECT_NE(run.record.message.find("scan.ply"), std::string::npos) << run.record.message;
}

/// Limits the files of the process, and of the tools that it calls, to this length.
void allow_files_of(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

TEST_F(ARecipe, RunOnADiskThatFillsIsNeverAnAcceptedHalf) {
  const Recipe recipe = make();
  const fs::path runs = folder_.path() / "runs";
  int accepted = 0;
  // From the first file that a run writes, over its copies of the inputs, up to everything that it
  // needs.
  constexpr std::array<rlim_t, 8> kBytes = {10,      1000,    10'000,  50'000,
                                            100'000, 300'000, 600'000, 100'000'000};
  for (const rlim_t bytes : kBytes) {
    const pid_t child = fork();
    if (child == 0) {
      allow_files_of(bytes);
      try {
        run_recipe(recipe, request("moved.ply"), {});
      } catch (const scan_cell_common::Error&) {
        _exit(42);
      }
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    for (const auto& entry : fs::directory_iterator(runs)) {
      SCOPED_TRACE(std::to_string(bytes) + " bytes: " + entry.path().string());
      EXPECT_NE(entry.path().filename().string().front(), '.') << "a half run stays";
      const RunRecord record = load_run(entry.path());
      EXPECT_NO_THROW(check_files(entry.path(), record));
      EXPECT_EQ(WEXITSTATUS(status), 0);
      if (record.state == RunState::kAccepted) {
        ++accepted;
        EXPECT_EQ(record.files.count("programs/plate.src"), 1u);
      } else {
        EXPECT_FALSE(record.message.empty());
      }
    }
    for (const auto& entry : fs::directory_iterator(runs))
      fs::remove_all(entry.path());
  }
  EXPECT_GT(accepted, 0);
  EXPECT_LT(accepted, static_cast<int>(kBytes.size()));
}

TEST_F(ARecipe, ThatWasEditedIsRefusedUntilItIsProven) {
  const Recipe recipe = make();
  std::string text = text_of(recipe.folder / "path.csv");
  text.resize(text.rfind('\n', text.size() - 2) + 1);  // one waypoint less
  scan_cell_common::save_text((recipe.folder / "path.csv").string(), text);
  try {
    run_recipe(recipe, request("moved.ply"), {});
    FAIL() << "it ran";
  } catch (const Refused& error) {
    EXPECT_EQ(error.thing(), (recipe.folder / "path.csv").string());
    EXPECT_NE(error.cure().find("recipe prove"), std::string::npos);
  }
  EXPECT_TRUE(fs::is_empty(folder_.path() / "runs")) << "nothing is left of it";
  ASSERT_EQ(problems_of(recipe).size(), 1u);
  prove(recipe, request("reference.ply"));
  EXPECT_TRUE(load_proof(recipe).proven);
  EXPECT_TRUE(problems_of(recipe).empty());
  const EndedRun run = run_recipe(recipe, request("moved.ply"), {});
  EXPECT_EQ(run.record.state, RunState::kAccepted);
  EXPECT_EQ(run.warning, "");
}

TEST_F(ARecipe, IsNotProvenByAPartOutOfTolerance) {
  const Recipe recipe = make();
  MadeUpPart::write_cloud(folder_.path() / "thick.ply", Eigen::Isometry3d::Identity(), 0.004);
  EXPECT_THROW(prove(recipe, request("thick.ply")), Refused);
  EXPECT_FALSE(load_proof(recipe).proven);
}

TEST_F(ARecipe, IsRefusedWhereTheCalibrationChanged) {
  const Recipe recipe = make();
  EXPECT_NO_THROW(
      check_calibration(recipe, load_proof(recipe), {{"scanner", "aa"}, {"cell", "bb"}}));
  EXPECT_THROW(check_calibration(recipe, load_proof(recipe), {{"scanner", "ab"}}), Refused);
  EXPECT_NE(
      check_calibration(recipe, load_proof(recipe), {}).find("does not name its scanner file"),
      std::string::npos);
  RunRequest scanned = request("moved.ply");
  scanned.scan_record = folder_.path() / "scan.json";
  scan_cell_common::save_text(
      scanned.scan_record->string(),
      R"({"scanned": 1, "calibration": {"scanner": {"name": "s.yaml", "sha256": "ab"}}})");
  EXPECT_THROW(run_recipe(recipe, scanned, {}), Refused);
}

TEST_F(ARecipe, IsNotMadeFromThePathOfAnotherPart) {
  scan_cell_common::save_text((folder_.path() / "path.csv").string(),
                              "x,y,z\n5,0,0\n5,0.1,0\n5,0.2,0\n");
  EXPECT_THROW(make(), scan_cell_common::UnusableInput);
  EXPECT_TRUE(recipe_names(folder_.path() / "recipes").empty());
}

TEST_F(ARecipe, IsNotMadeWithAnUnknownParameter) {
  made_.stretch = {{"max_deformation", "0.1"}};
  EXPECT_THROW(make(), scan_cell_common::Error) << "its old name";
  made_.stretch = {{"speed", "0.1"}};
  EXPECT_THROW(make(), scan_cell_common::UnusableInput);
}

TEST_F(ARecipe, IsNotMadeTwice) {
  make();
  EXPECT_THROW(make(), scan_cell_common::FileError);
}

TEST_F(ARecipe, WithAMissingFileIsRefusedByItsName) {
  const Recipe recipe = make();
  fs::remove(recipe.folder / "reference.ply");
  try {
    run_recipe(recipe, request("moved.ply"), {});
    FAIL() << "it ran";
  } catch (const scan_cell_common::FileError& error) {
    EXPECT_EQ(error.thing(), (recipe.folder / "reference.ply").string());
  }
}

}  // namespace
}  // namespace part_recipes
