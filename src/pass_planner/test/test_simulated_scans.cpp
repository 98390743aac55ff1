// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "cures.h"
#include "measurements.h"

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

}  // namespace
}  // namespace pass_planner
