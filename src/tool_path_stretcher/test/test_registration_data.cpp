// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>

#include "alignment/refinement.h"
#include "search/candidates.h"
#include "yardsticks/registration_data.h"

using namespace tool_path_stretcher;

/// A real lidar cloud, and the same cloud scaled by 1.04 and rotated by 11.459 degrees.
class Car : public testing::Test {
 protected:
  void SetUp() override {
    const char* data = std::getenv("SCAN_CELL_DATA");
    if (data == nullptr || !cases::has_registration_data(data)) {
      GTEST_SKIP() << "NOT TESTED on the car: set SCAN_CELL_DATA to the folder that holds "
                      "registration/car";
    }
    const cases::Pair car = cases::car_pair(data);
    const Eigen::Vector3d leaf = Eigen::Vector3d::Constant(0.02);
    reference_ = surface_from_cloud(car.reference, leaf, "reference");
    object_ = surface_from_cloud(car.object, leaf, "object");
  }

  static void expect_found(const Similarity& found) {
    EXPECT_NEAR(found.scale, 1.04, 0.001);
    EXPECT_NEAR(cases::angle_of(found.rotation) * 180 / M_PI, 11.459, 0.05);
  }

  Surface reference_;
  Surface object_;
};

TEST_F(Car, IsFoundFromIdentity) {
  expect_found(refine({reference_, object_}, Similarity(), ScalePrior{}, Density::kMany, 60));
}

TEST_F(Car, IsFoundWithNothingKnown) {
  const auto candidates = find_candidates({reference_, object_}, Prior{}, [](double) {});
  ASSERT_FALSE(candidates.empty());
  expect_found(candidates.front().similarity);
}
