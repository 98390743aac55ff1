// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "made_up_part.h"
#include "made_up_recipe.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "view/run_view.h"

namespace part_recipes {
namespace {

using ARunView = MadeUpRecipe;

TEST_F(ARunView, OfAnAcceptedRunPutsThePathWhereThePartLies) {
  const Recipe recipe = make();
  const RunView view = view_of(run_recipe(recipe, request("moved.ply"), {}).folder);
  EXPECT_EQ(view.frame, "world");
  const tool_paths::Points adapted = positions_of(view.adapted), path = positions_of(view.path);
  ASSERT_FALSE(adapted.empty());
  ASSERT_EQ(path.size(), adapted.size());
  const Eigen::Vector3d truth = MadeUpPart::moved() * Eigen::Vector3d(0.09, 0.01, 0);
  EXPECT_LT((adapted.front() - truth).head<2>().norm(), 3e-4);
  EXPECT_LT((path.front() - truth).head<2>().norm(), 3e-4) << "the part was only moved";
  EXPECT_TRUE(view.concerned.empty());
}

TEST_F(ARunView, OfARefusedRunShowsTheWaypointsThatTheVerdictIsAbout) {
  // Nothing was scanned around the path's first waypoint.
  const Eigen::Vector3d first = MadeUpPart::moved() * Eigen::Vector3d(0.09, 0.01, 0);
  scan_cell_common::Cloud scanned =
      scan_cell_common::load_cloud((folder_.path() / "moved.ply").string());
  scan_cell_common::Cloud with_hole;
  for (const auto& point : scanned)
    if ((point.getVector3fMap().cast<double>() - first).norm() > 0.02) with_hole.push_back(point);
  ASSERT_LT(with_hole.size(), scanned.size());
  scan_cell_common::save_cloud((folder_.path() / "hole.ply").string(), with_hole);
  const EndedRun run = run_recipe(make(), request("hole.ply"), {});
  ASSERT_EQ(run.record.state, RunState::kRefused);
  const RunView view = view_of(run.folder);
  EXPECT_TRUE(view.adapted.segments.empty());
  ASSERT_FALSE(view.concerned.empty()) << run.record.message;
  EXPECT_LT((view.positions.front() - first).norm(), 0.02);
  ASSERT_EQ(view.positions.size(), view.concerned.size());
  const tool_paths::Points path = positions_of(view.path);
  for (std::size_t i = 0; i < view.concerned.size(); ++i)
    EXPECT_EQ(view.positions[i], path.at(view.concerned[i]));
}

TEST_F(ARunView, OfARunThatEndedBeforeThereWasAReportIsEmpty) {
  scan_cell_common::save_text((folder_.path() / "broken.ply").string(), "ply\nno more\n");
  const RunView view = view_of(run_recipe(make(), request("broken.ply"), {}).folder);
  EXPECT_TRUE(view.path.segments.empty());
  EXPECT_TRUE(view.adapted.segments.empty());
  EXPECT_TRUE(view.positions.empty());
}

TEST_F(ARunView, OfAFolderThatIsNoRunIsRefused) {
  EXPECT_THROW(view_of(folder_.path() / "nothing"), scan_cell_common::FileError);
}

}  // namespace
}  // namespace part_recipes
