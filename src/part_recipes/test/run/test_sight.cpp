// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "made_up_recipe.h"
#include "run/again.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/files/sha256.h"
#include "view/run_view.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// A run of a given cloud, with the cell's record of its scan.
class ASight : public MadeUpRecipe {
 protected:
  /// A recipe whose scan is a line along x, 595 mm over the plate's plane, beside it or not.
  Recipe scanned_along(double y) {
    const auto flange_at = [y](double x) {
      return Eigen::Translation3d(x, y, 0.595) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
    };
    scan_cell::ScanPass pass;
    pass.poses = {Eigen::Isometry3d(flange_at(-0.15)), Eigen::Isometry3d(flange_at(0.35))};
    pass.speed = 0.06;
    pass.rate = 100;
    made_.program = (folder_.path() / "program.yaml").string();
    scan_cell::save_scan_program(made_.program, {"world", {pass}});
    made_.calibration.clear();
    return make();
  }

  /// @param sha256 of the scanner model, as reported by the cell
  RunRequest scanned_with(const std::string& sha256) const {
    RunRequest scanned = request("moved.ply");
    scanned.scan_record = folder_.path() / "scan.json";
    scan_cell_common::save_text(
        scanned.scan_record->string(),
        fmt::format(
            R"({{"scanned": 1, "calibration": {{"scanner": {{"name": "{}", "sha256": "{}"}}}},
                    "camera_region": {{"x": 336, "y": 599, "width": 1024, "height": 512}}}})",
            SCANNER_FILE, sha256));
    return scanned;
  }

  const std::string sha256_ = scan_cell_common::sha256_of_file(SCANNER_FILE);
};

TEST_F(ASight, OfALineOverThePathIsOfAllItsWaypoints) {
  const EndedRun run = run_recipe(scanned_along(0.05), scanned_with(sha256_), {});
  const auto sight = nlohmann::json::parse(text_of(run.folder / "sight.json"));
  EXPECT_GT(sight.at("waypoints"), 20);
  EXPECT_EQ(sight.at("seen"), sight.at("waypoints"));
  EXPECT_EQ(text_of(run.folder / "inputs" / "scanner_model.yaml"), text_of(SCANNER_FILE));
  EXPECT_TRUE(view_of(run.folder).unseen.empty());
}

TEST_F(ASight, OfALineBesideThePartIsOfNone) {
  const EndedRun run = run_recipe(scanned_along(1), scanned_with(sha256_), {});
  EXPECT_EQ(run.record.state, RunState::kAccepted) << "the cloud that was given shows it";
  const auto unseen = view_of(run.folder).unseen;
  ASSERT_GT(unseen.size(), 20U);
  const Eigen::Vector3d first = MadeUpPart::moved() * Eigen::Vector3d(0.09, 0.01, 0.012);
  EXPECT_LT((unseen.front().position - first).norm(), 1e-3);
  for (const UnseenWaypoint& each : unseen)
    EXPECT_EQ(each.sight, "out_of_range");
}

TEST_F(ASight, OfARunThatIsRunAgainIsTheSameBytes) {
  const fs::path run = run_recipe(scanned_along(0.05), scanned_with(sha256_), {}).folder;
  const fs::path again = run_again(run, folder_.path() / "runs", {}, {}).folder;
  EXPECT_EQ(text_of(again / "sight.json"), text_of(run / "sight.json"));
  EXPECT_TRUE(differences(run, again).empty());
}

TEST_F(ASight, IsNotMadeUpWithoutTheScannerModelOfTheScan) {
  const EndedRun run = run_recipe(scanned_along(0.05), scanned_with("ab"), {});
  EXPECT_FALSE(fs::exists(run.folder / "sight.json"));
  EXPECT_NE(run.warning.find("not known what the scan could see"), std::string::npos);
}

}  // namespace
}  // namespace part_recipes
