// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "coverage.h"
#include "cures.h"
#include "measurements.h"
#include "scan_cell/scan_program.h"
#include "simulated_scan.h"

namespace pass_planner {
namespace {

TEST(SimulatedScans, ShowWhatIsSaidToBeSeenAndOnlyThat) {
  const Agreement found = measure_agreement(SCANNER_FILE, 1, 4);  // one of each kind
  ASSERT_GT(found.seen, 50U);
  ASSERT_GT(found.hidden, 50U);
  EXPECT_GE(static_cast<double>(found.seen_and_there), 0.95 * static_cast<double>(found.seen));
  EXPECT_GE(static_cast<double>(found.hidden_and_gone), 0.95 * static_cast<double>(found.hidden));
}

TEST(SimulatedScans, OnePlannedPassCuresARefusalForAMissingScan) {
  constexpr std::uint64_t kSeed = 1004;  // a frame, scanned along a line that ends over it
  const CureTrial trial = run_cure({SCANNER_FILE, CELL_FILE, URDF_FILE}, kSeed);
  ASSERT_TRUE(trial.not_scanned) << trial.first_verdict;
  EXPECT_GT(trial.missing, 0U);
  EXPECT_TRUE(trial.cured) << trial.second_verdict << ": " << trial.why;
}

class CoverageOfAFrame : public testing::Test {
 protected:
  Coverage of(const std::vector<Eigen::Vector3d>& cloud) const {
    return measure_coverage(world_, passes_, scanner_, cloud);
  }

  std::vector<Eigen::Vector3d> scanned() const {
    return simulated_scan(scan_cell_sim::Scene(world_), scanner_, sweeps_of(passes_));
  }

 private:
  const std::string config_ = std::string(SOURCE_FOLDER) + "/";
  const scan_cell_sim::World world_ =
      scan_cell_sim::load_world(config_ + "scan_cell_sim/config/reference_frame.yaml");
  const std::vector<scan_cell::ScanPass> passes_ =
      scan_cell::load_scan_program(config_ + "scan_cell/config/three_passes.yaml").passes;
  const scan_cell_common::ScannerModel scanner_ =
      scan_cell_common::load_scanner_model(SCANNER_FILE);
};

TEST_F(CoverageOfAFrame, ByThreePassesAndBothLasersIsNearlyWhole) {
  const std::vector<Eigen::Vector3d> cloud = scanned();
  const Coverage coverage = of(cloud);
  EXPECT_GE(coverage.share(M_PI / 2), 0.98);
  EXPECT_LE(coverage.error.rms, 0.08e-3);
  EXPECT_LE(coverage.error.max, 1e-3);

  std::vector<Eigen::Vector3d> half;
  std::copy_if(cloud.begin(), cloud.end(), std::back_inserter(half),
               [](const Eigen::Vector3d& point) { return point.x() < 0; });
  EXPECT_NEAR(of(half).share(M_PI / 2), 0.5, 0.05) << "what is missing does not count";
}

}  // namespace
}  // namespace pass_planner
