// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "made_up_part.h"
#include "recipe/new_recipe.h"
#include "run/run_recipe.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {

/// A recipe of the made-up part, and scans of it.
class MadeUpRecipe : public testing::Test {
 protected:
  MadeUpRecipe() {
    MadeUpPart::write_cloud(folder_.path() / "reference.ply", Eigen::Isometry3d::Identity());
    MadeUpPart::write_cloud(folder_.path() / "moved.ply", MadeUpPart::moved());
    MadeUpPart::write_path(folder_.path() / "path.csv");
    // The made-up part lies on no floor, and nothing lies beside it.
    scan_cell_common::save_text(
        (folder_.path() / "cleaning.yaml").string(),
        "floor: {automatic: false}\noutliers: {automatic: false}\nisolate: {select: all}\n"
        "grid: false\n");
    made_.name = "Platte groß";
    made_.reference.file = (folder_.path() / "reference.ply").string();
    made_.path.file = (folder_.path() / "path.csv").string();
    made_.cleaning = (folder_.path() / "cleaning.yaml").string();
    made_.programs = {{"plate.src", {{"waypoint_z", "into_part"}}}};
    made_.calibration = {{"scanner", "aa"}};
  }

  Recipe make() const { return make_recipe(folder_.path() / "recipes", made_); }

  RunRequest request(const std::string& scan) const {
    RunRequest request;
    request.runs = folder_.path() / "runs";
    request.scan = folder_.path() / scan;
    return request;
  }

  TemporaryFolder folder_;
  NewRecipe made_;
};

}  // namespace part_recipes
