// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "made_up_recipe.h"
#include "replay/replay.h"
#include "run/run_folder.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLease(60);

class ARecordedRun : public MadeUpRecipe {
 protected:
  ARecordedRun() : recorded_(run_recipe(make(), request("moved.ply"), {})) {}

  /// Replays it with the present recipe under another name.
  std::vector<ReplayedRun> replay() {
    made_.name = "other";
    const Recipe other = make();
    jobs_.add({{recorded_.record.id, recorded_.folder, other.folder}});
    EXPECT_EQ(work_on(jobs_, kLease, {}, {}), 1u);
    return replayed(jobs_);
  }

  EndedRun recorded_;
  JobFolder jobs_{folder_.path() / "jobs"};
};

TEST_F(ARecordedRun, WithTheSameRecipeMovesNoWaypoint) {
  const auto runs = replay();
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].after.state, RunState::kAccepted);
  EXPECT_EQ(runs[0].moved_most, 0.0);
  EXPECT_EQ(runs[0].after.again_of, recorded_.record.id);
}

TEST_F(ARecordedRun, WithAPathThatWasShiftedMovesItsWaypointsSo) {
  constexpr double kShift = 0.003;  // [m] along the flat top of the step
  std::string text = text_of(made_.path.file), shifted = text.substr(0, text.find('\n') + 1);
  for (std::size_t at = text.find('\n') + 1; at < text.size();) {
    const std::size_t comma = text.find(',', at), end = text.find('\n', at);
    shifted += std::to_string(std::stod(text.substr(at, comma - at)) + kShift) +
               text.substr(comma, end - comma + 1);
    at = end + 1;
  }
  scan_cell_common::save_text(made_.path.file, shifted);
  const auto runs = replay();
  ASSERT_EQ(runs.size(), 1u);
  ASSERT_TRUE(runs[0].moved_most) << runs[0].after.message;
  EXPECT_NEAR(*runs[0].moved_rms, kShift, 5e-5);
  EXPECT_NEAR(*runs[0].moved_most, kShift, 1e-4);
}

TEST_F(ARecordedRun, WithAnotherVerdictIsToldSo) {
  made_.stretch = {{"min_scale", "1.2"}};
  const auto runs = replay();
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].after.state, RunState::kRefused);
  EXPECT_NE(to_text(runs).find("accepted -> refused"), std::string::npos) << to_text(runs);
  EXPECT_NE(to_text(runs).find("1 runs: 1 verdicts changed"), std::string::npos) << to_text(runs);
}

TEST_F(ARecordedRun, ThatWasChangedIsRefusedAndItsJobGivenBack) {
  scan_cell_common::save_text((recorded_.folder / "object.ply").string(), "changed");
  jobs_.add(
      {{recorded_.record.id, recorded_.folder, make_recipe(folder_.path() / "b", made_).folder}});
  EXPECT_THROW(work_on(jobs_, kLease, {}, {}), scan_cell_common::UnusableInput);
  EXPECT_TRUE(jobs_.claim(kLease)) << "it is free again";
}

TEST_F(ARecordedRun, ThatIsStoppedLeavesNoRun) {
  jobs_.add(
      {{recorded_.record.id, recorded_.folder, make_recipe(folder_.path() / "b", made_).folder}});
  int asked = 0;
  const Stop soon = [&asked] { return ++asked > 3; };
  EXPECT_THROW(work_on(jobs_, kLease, {}, soon), scan_cell_common::Refused);
  EXPECT_TRUE(fs::is_empty(jobs_.runs()));
  EXPECT_TRUE(jobs_.claim(kLease));
}

}  // namespace
}  // namespace part_recipes
