// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a part still lies where it was scanned, on the made-up part.
#include <gtest/gtest.h>

#include <cstdlib>

#include "made_up_recipe.h"
#include "run/place_check.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// A run of the moved part, with a recipe that checks its place before the work.
class APlaceCheck : public MadeUpRecipe {
 protected:
  APlaceCheck() {
    scan_cell_common::save_text(
        (folder_.path() / "check.yaml").string(),
        "frame: world\npasses:\n  - line:\n"
        "      start: {translation: [-0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
        "      end: {translation: [0.1, 0, 0.6], rotation: [1, 0, 0, 0]}\n"
        "    speed: 0.06\n    rate: 100\n    laser: 1\n");
    made_.check_program = (folder_.path() / "check.yaml").string();
    recipe_ = make();
    run_ = run_recipe(recipe_, request("moved.ply"), {});
  }

  /// Checks a scan with the part turned and shifted since the run.
  PlaceCheck after(const Eigen::Isometry3d& moved, double added = 0) {
    const fs::path scan = folder_.path() / "again.ply";
    MadeUpPart::write_cloud(scan, moved * MadeUpPart::moved(), added);
    return check_place(recipe_, run_.folder, request("moved.ply"), {}, scan);
  }

  Recipe recipe_;
  EndedRun run_;
};

Eigen::Isometry3d shifted(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

TEST_F(APlaceCheck, LetsAPartBeWorkedThatLiesWhereItWasScanned) {
  ASSERT_EQ(run_.record.state, RunState::kAccepted) << run_.record.message;
  const PlaceCheck found = after(shifted(0.0001, 0, 0));
  EXPECT_TRUE(found.lies_there) << found.message;
  EXPECT_NEAR(found.moved.value(), 0.0001, 0.0001) << found.message;
  const std::string record = text_of(run_.folder.string() + ".check.json");
  EXPECT_NE(record.find("\"lies_there\": true"), std::string::npos) << record;
  EXPECT_NO_THROW(check_files(run_.folder, load_run(run_.folder))) << "the run stays as it was";
  for (const auto& entry : fs::directory_iterator(run_.folder.parent_path()))
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path() << " is left";
}

TEST_F(APlaceCheck, SaysByHowMuchThePartWasShiftedOrTurned) {
  for (const Eigen::Isometry3d& shift :
       {shifted(0.001, 0, 0), shifted(0, 0.001, 0), shifted(0, 0, 0.001)}) {
    const PlaceCheck found = after(shift);
    EXPECT_FALSE(found.lies_there) << found.message;
    EXPECT_NEAR(found.moved.value(), 0.001, 0.0002) << found.message;
    EXPECT_NE(found.message.find("run the part again"), std::string::npos);
  }
  // about the world's origin, up to 0.12 m from it
  const PlaceCheck turned =
      after(Eigen::Isometry3d(Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ())));
  EXPECT_FALSE(turned.lies_there);
  EXPECT_GT(turned.moved.value(), 0.001) << turned.message;
}

TEST_F(APlaceCheck, DoesNotTakeAnotherPartForThePart) {
  Eigen::Isometry3d mirrored = Eigen::Isometry3d::Identity();
  mirrored.matrix()(0, 0) = -1;
  const PlaceCheck found = after(mirrored);
  EXPECT_FALSE(found.lies_there);
  EXPECT_NE(found.message.find("not found again"), std::string::npos) << found.message;
}

TEST_F(APlaceCheck, ThatCannotBeMadeIsNoLeaveToWork) {
  const fs::path scan = folder_.path() / "broken.ply";
  scan_cell_common::save_text(scan.string(), "ply\nno more\n");
  const PlaceCheck found = check_place(recipe_, run_.folder, request("moved.ply"), {}, scan);
  EXPECT_FALSE(found.lies_there);
  EXPECT_NE(found.message.find("where it was scanned: clean failed"), std::string::npos)
      << found.message;
}

TEST_F(APlaceCheck, OfARunThatTheRecipeDidNotMakeIsRefused) {
  fs::remove(run_.folder / "inputs/check.yaml");
  EXPECT_THROW(
      check_place(recipe_, run_.folder, request("moved.ply"), {}, folder_.path() / "moved.ply"),
      scan_cell_common::FileError);
}

TEST_F(APlaceCheck, StandsBeforeTheWork) {
  RunRequest work_it = request("moved.ply");
  work_it.work = Work::kReal;
  setenv("ROS_MASTER_URI", "http://localhost:1", 1);             // nobody is there
  work(load_recipe(run_.folder / "inputs"), work_it, {}, run_);  // as of a run that is chosen later
  EXPECT_FALSE(run_.worked);
  EXPECT_NE(run_.work_message.find("scan failed: scan: ROS master"), std::string::npos)
      << run_.work_message;
}

}  // namespace
}  // namespace part_recipes
