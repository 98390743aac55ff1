// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "cloud_builder.h"
#include "scan_cell_common/errors/errors.h"

using laser_triangulation::CloudBuilder;
using scan_cell_common::Refused;
using scan_cell_common::ScannerModel;
using scan_cell_common::UnusableInput;
using scan_cell_msgs::BoundProfile;

namespace {

constexpr std::size_t kRows = 10;

/// One laser whose plane meets the camera's axis at z = 0.5 m.
scan_cell_common::ScannerModel scanner() {
  scan_cell_common::ScannerModel model;
  model.camera.width = model.camera.height = 1000;
  model.camera.fx = model.camera.fy = 800;
  model.camera.cx = model.camera.cy = 500;
  scan_cell_common::LaserPlane laser;
  laser.origin << 0.25, 0, 0;
  laser.normal = Eigen::Vector3d(2, 0, 1).normalized();
  laser.distance = laser.normal.dot(laser.origin);
  model.lasers.push_back(laser);
  return model;
}

BoundProfile profile() {
  BoundProfile bound;
  bound.header.frame_id = "world";
  bound.profile.frame_counter = 7;
  bound.profile.laser = 0;
  bound.profile.first_row = 400;
  bound.profile.position.assign(kRows, 500);
  bound.profile.width.assign(kRows, 5);
  bound.profile.intensity.assign(kRows, 100);
  bound.pose.orientation.w = 1;
  return bound;
}

class CloudBuilderTest : public testing::Test {
 protected:
  /// The error with which a changed profile is refused; none of it may be added.
  template <class Error>
  std::string refusal(const std::function<void(BoundProfile&)>& change) {
    const std::size_t before = builder_.points().size();
    BoundProfile bad = profile();
    change(bad);
    try {
      builder_.add(bad);
    } catch (const Error& error) {
      EXPECT_EQ(builder_.points().size(), before);
      return error.what();
    }
    return "taken";
  }

  CloudBuilder builder_{scanner(), {}, 2 * kRows};
};

}  // namespace

TEST_F(CloudBuilderTest, TakesAProfile) {
  builder_.add(profile());
  ASSERT_EQ(builder_.points().size(), kRows);
  EXPECT_NEAR(builder_.points()[0].x, 0, 1e-6);
  EXPECT_NEAR(builder_.points()[0].z, 0.5, 1e-6);
}

TEST_F(CloudBuilderTest, RefusesUnusablePoses) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(BoundProfile&)>> changes = {
      [](BoundProfile& bad) { bad.pose.orientation.w = 0; },
      [](BoundProfile& bad) { bad.pose.orientation.w = 1.1; },
      [&](BoundProfile& bad) { bad.pose.orientation.x = nan; },
      [&](BoundProfile& bad) { bad.pose.position.y = nan; },
      [](BoundProfile& bad) { bad.pose.position.z = std::numeric_limits<double>::infinity(); }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::string why = i < 3 ? "a quaternion of length" : "its position is not finite";
    EXPECT_NE(refusal<UnusableInput>(changes[i]).find("frame 7: " + why), std::string::npos) << i;
  }
}

TEST_F(CloudBuilderTest, RefusesArraysOfDifferentLengths) {
  EXPECT_NE(refusal<UnusableInput>([](BoundProfile& bad) {
              bad.profile.width.pop_back();
            }).find("different lengths"),
            std::string::npos);
  EXPECT_NE(refusal<UnusableInput>([](BoundProfile& bad) {
              bad.profile.intensity.clear();
            }).find("different lengths"),
            std::string::npos);
}

TEST_F(CloudBuilderTest, RefusesALaserThatTheScannerDoesNotHave) {
  EXPECT_NE(
      refusal<UnusableInput>([](BoundProfile& bad) { bad.profile.laser = 1; }).find("laser 1"),
      std::string::npos);
}

TEST_F(CloudBuilderTest, RefusesASecondFrame) {
  builder_.add(profile());
  EXPECT_NE(refusal<UnusableInput>([](BoundProfile& bad) {
              bad.header.frame_id = "base_link";
            }).find("in frame base_link"),
            std::string::npos);
}

TEST_F(CloudBuilderTest, RefusesMorePointsThanAllowed) {
  builder_.add(profile());
  builder_.add(profile());
  EXPECT_NE(refusal<Refused>([](BoundProfile&) {}).find("full with 20 points"), std::string::npos);
}

namespace {

/// The second laser mirrors the first: a pixel's ray meets its plane at another depth.
scan_cell_common::ScannerModel two_lasers() {
  scan_cell_common::ScannerModel model = scanner();
  scan_cell_common::LaserPlane other = model.laser(0);
  other.origin << -0.3, 0, 0;
  other.normal = Eigen::Vector3d(-2, 0, 1).normalized();
  other.distance = other.normal.dot(other.origin);
  model.lasers.push_back(other);
  return model;
}

BoundProfile profile_of(std::uint8_t laser) {
  BoundProfile bound = profile();
  bound.profile.laser = laser;
  return bound;
}

}  // namespace

TEST(CloudOfTwoLasers, RefusesALaserThatWasNotCalibratedByName) {
  scan_cell_common::ScannerModel model = two_lasers();
  model.lasers[0].reset();
  CloudBuilder builder(model, {}, 1000);
  builder.add(profile_of(1));
  try {
    builder.add(profile_of(0));
    FAIL() << "points of a plane that was never found";
  } catch (const UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("laser_0 is not calibrated"), std::string::npos)
        << error.what();
  }
  model.lasers[1].reset();
  EXPECT_THROW(CloudBuilder(model, {}, 1000), UnusableInput);
}

TEST(CloudOfTwoLasers, IsTheSameWhetherTheyAlternateOrScanInSeparatePasses) {
  CloudBuilder alternating(two_lasers(), {}, 1000), passes(two_lasers(), {}, 1000);
  for (const std::uint8_t laser : {0, 1, 0, 1})
    alternating.add(profile_of(laser));
  for (const std::uint8_t laser : {0, 0, 1, 1})
    passes.add(profile_of(laser));
  for (const CloudBuilder* builder : {&alternating, &passes}) {
    ASSERT_EQ(builder->points().size(), 4 * kRows);
    std::size_t of_laser[2] = {0, 0};
    for (std::size_t i = 0; i < builder->points().size(); ++i) {
      const laser_triangulation::ScanPoint& point = builder->points()[i];
      EXPECT_NEAR(point.z, point.laser == 0 ? 0.5 : 0.6, 1e-6);
      ++of_laser[point.laser];
    }
    EXPECT_EQ(of_laser[0], 2 * kRows);
    EXPECT_EQ(of_laser[1], 2 * kRows);
    const std::vector<std::uint64_t> counted = {2 * kRows, 2 * kRows};
    EXPECT_EQ(builder->statistics("scan").points_of_laser, counted);
  }
}

TEST(CloudOfTwoLasers, NamesThePassAndTheLaserThatGaveNoLine) {
  CloudBuilder builder(two_lasers(), {}, 1000);
  const auto add = [&builder](std::uint32_t pass, std::uint8_t laser, bool lit) {
    BoundProfile bound = profile_of(laser);
    bound.pass_index = pass;
    if (!lit) bound.profile.position.assign(kRows, std::numeric_limits<float>::quiet_NaN());
    builder.add(bound);
  };
  EXPECT_EQ(builder.find_dark_sweep(), "") << "nothing was scanned yet";
  add(0, 0, true);
  add(0, 1, true);
  add(1, 0, true);
  for (int i = 0; i < 3; ++i)
    add(1, 1, false);
  EXPECT_EQ(builder.find_dark_sweep().find("pass 2: laser_1 gave no line in 3 profiles"), 0U)
      << builder.find_dark_sweep();
  add(1, 1, true);
  EXPECT_EQ(builder.find_dark_sweep(), "") << "one line is one";
}

namespace {

/// Adds two passes over a flat strip of 60 x 60 mm.
void scan_twice(CloudBuilder& builder) {
  constexpr std::size_t kWide = 100;  // rows, 0.6 mm apart
  for (std::uint32_t pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < 100; ++i) {
      BoundProfile bound = profile();
      bound.profile.position.assign(kWide, 500);
      bound.profile.width.assign(kWide, 5);
      bound.profile.intensity.assign(kWide, 100);
      bound.pass_index = pass;
      bound.pose.position.x = 0.6e-3 * i;
      builder.add(bound);
    }
  }
}

}  // namespace

TEST(CloudOfTwoPasses, TakesNoLateProfileAmongPointsThatWereMoved) {
  CloudBuilder mended(scanner(), {}, 100000, {0.2e-3}), measured(scanner(), {}, 100000);
  for (CloudBuilder* builder : {&mended, &measured}) {
    scan_twice(*builder);
    builder->bring_together();
  }
  ASSERT_EQ(mended.statistics("").corrections.size(), 2U);
  const std::size_t before = mended.points().size();
  try {
    mended.add(profile());
    FAIL() << "one cloud of points that were moved and of one that was not";
  } catch (const Refused& error) {
    EXPECT_NE(std::string(error.what()).find("after the passes were brought together"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(mended.points().size(), before);
  measured.add(profile());
  EXPECT_EQ(measured.points().size(), before + kRows) << "nothing was moved there";
}

TEST(AgreementLines, SayTheFiguresOfAPairOnce) {
  scan_cell_msgs::CloudStatistics statistics;
  statistics.agreement_message = "pass 1 laser_0 and pass 2 laser_0 lie 0.040 mm apart";
  statistics.overlaps.resize(1);
  EXPECT_EQ(CloudBuilder::agreement_lines(statistics),
            std::vector<std::string>{statistics.agreement_message});
  statistics.overlaps.resize(3);
  EXPECT_EQ(CloudBuilder::agreement_lines(statistics).size(), 4U) << "the worst, and each";
}
