// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause A height field
// under a vertical plane of light, in closed form, with poses stamped late.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "scan_cell_common/errors/errors.h"
#include "time_offset/time_offset.h"

using namespace pose_frame_binder;  // NOLINT
using scan_cell_common::from_seconds;

namespace {

using Height = std::function<double(double x, double y)>;

struct Truth {
  double delay = 0.0123;          // [s]
  double speed = 0.1;             // [m/s]
  double point_noise = 30e-6;     // [m] along the camera's axis
  double pose_noise = 20e-6;      // [m]
  double line_rate = 100;         // [Hz]
  double pose_rate = 250;         // [Hz]
  double point_spacing = 0.0014;  // [m] along the line
  bool ramps = true;              // also lines while the robot accelerates and stops
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  // of the scan back, which is not a delay
  Eigen::Isometry3d scene = Eigen::Isometry3d::Identity();  // pose of the scene in the world
};

/// Hills of a few millimetres on a plane.
double hills(double x, double y) {
  return 0.004 * std::sin(70 * x + 20 * y) + 0.003 * std::sin(45 * x - 60 * y + 1);
}

/// The flange looks down from 0.4 m, with the plane of light through its z axis and across its x.
UnboundScan scan(const Height& height, double direction, const Truth& truth, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise;
  constexpr double kLength = 0.2;                     // [m]
  constexpr double kRamp = 0.15;                      // [s] to the speed and to a stop
  constexpr double kAbove = 0.4;                      // [m]
  const double most = kLength / truth.speed + kRamp;  // [s]
  const auto way = [&](double t) {                    // with constant acceleration at both ends
    t = std::clamp(t, 0.0, most);
    const double early = std::min(t, kRamp), late = std::max(0.0, t - (most - kRamp));
    return truth.speed *
           (early * early / (2 * kRamp) + std::max(0.0, t - kRamp) - late * late / (2 * kRamp));
  };
  const auto flange = [&](double t) -> Eigen::Isometry3d {
    const double x = direction > 0 ? way(t) : kLength - way(t);
    return truth.scene * Eigen::Translation3d(x, 0, kAbove) *
           Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX());
  };
  UnboundScan result;
  for (double t = -0.2; t < most + 0.3; t += 1 / truth.pose_rate) {
    TimedPose pose;
    pose.time = from_seconds(100 + t + truth.delay);  // stamped late
    pose.pose = flange(t);
    pose.pose.translation() +=
        truth.pose_noise * Eigen::Vector3d(noise(random), noise(random), noise(random));
    if (direction < 0) pose.pose.translation() += truth.shift;
    result.poses.push_back(pose);
  }
  for (double t = 0.0017; t < most; t += 1 / truth.line_rate) {
    constexpr double kAway = kRamp + 0.1;  // for any delay
    if (!truth.ramps && (t < kAway || t > most - kAway)) continue;
    UnboundScan::Line line;
    line.time = from_seconds(100 + t);
    const double x = (truth.scene.inverse() * flange(t)).translation().x();
    for (double y = -0.05; y <= 0.05; y += truth.point_spacing) {
      // Seen from the flange: y and z point the other way.
      line.points.emplace_back(0, -y, kAbove - height(x, y) + truth.point_noise * noise(random));
    }
    result.lines.push_back(line);
  }
  return result;
}

TimeOffset estimate(const Height& height, const Truth& truth, unsigned seed = 1,
                    const TimeOffsetSettings& settings = {}) {
  return estimate_time_offset(scan(height, 1, truth, 2 * seed),
                              scan(height, -1, truth, 2 * seed + 1), settings);
}

std::string refusal(const Height& height, const Truth& truth) {
  try {
    estimate(height, truth);
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "taken";
}

}  // namespace

TEST(TimeOffset, IsFoundWithinThreeOfItsStandardDeviations) {
  for (const double delay : {0.0123, -0.0071, 0.0, 0.040, -0.060}) {
    Truth truth;
    truth.delay = delay;
    const TimeOffset found = estimate(hills, truth);
    EXPECT_NEAR(found.pose_delay, delay, 3 * found.uncertainty) << delay;
    EXPECT_LT(found.uncertainty, 2e-4);
    EXPECT_GE(found.uncertainty, found.from_posterior);
    EXPECT_GE(found.uncertainty, found.from_residuals);
    EXPECT_LT(found.apart_after, 1e-4);
    if (std::abs(delay) > 0.005) {
      EXPECT_GT(found.apart_before, 2 * found.apart_after);
    }
  }
}

TEST(TimeOffset, IsAsUncertainAsItSays) {
  constexpr unsigned kScans = 10;
  double squares = 0;
  for (unsigned seed = 1; seed <= kScans; ++seed) {
    Truth truth;
    truth.speed = 0.2;
    const TimeOffset found = estimate(hills, truth, seed);
    squares += std::pow((found.pose_delay - truth.delay) / found.uncertainty, 2);
  }
  const double ratio = std::sqrt(squares / kScans);  // 1 +- 0.2 were it exact
  RecordProperty("error_over_uncertainty", std::to_string(ratio));
  EXPECT_LT(ratio, 1.5);
  EXPECT_GT(ratio, 0.3);
}

TEST(TimeOffset, DoesNotTakeAShiftAcrossTheMotionForTime) {
  Truth truth;
  truth.shift << 0, 0.0002, 0.0003;
  const TimeOffset found = estimate(hills, truth);
  EXPECT_NEAR(found.pose_delay, truth.delay, 3 * found.uncertainty);
}

TEST(TimeOffset, IsFoundInAnyPlaceAndDirection) {
  Truth truth;
  truth.scene = Eigen::Translation3d(1, -0.5, 0.3) *
                Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 3).normalized());
  const TimeOffset found = estimate(hills, truth);
  EXPECT_NEAR(found.pose_delay, truth.delay, 3 * found.uncertainty);
}

TEST(TimeOffset, IsFoundFromARoofAlone) {
  const Height roof = [](double x, double) { return 0.02 - 0.7 * std::abs(x - 0.1); };
  const TimeOffset found = estimate(roof, {});
  EXPECT_NEAR(found.pose_delay, Truth().delay, 3 * found.uncertainty);
}

TEST(TimeOffset, IsFoundFromASmallRoofOnAWidePlateWhateverTheDelay) {
  const Height roof = [](double x, double) { return std::max(0.0, 0.012 - std::abs(x - 0.1)); };
  for (double delay = 0.005; delay < 0.0101; delay += 0.0005) {
    Truth truth;
    truth.delay = delay;
    const TimeOffset found = estimate(roof, truth);
    EXPECT_NEAR(found.pose_delay, delay, 4 * found.uncertainty) << delay;
  }
}

TEST(TimeOffset, IsRefusedWithoutReliefAlongTheMotion) {
  EXPECT_NE(refusal([](double, double) { return 0.0; }, {}).find("relief along the motion"),
            std::string::npos);
  const Height across = [](double, double y) { return 0.01 * std::sin(80 * y); };
  EXPECT_NE(refusal(across, {}).find("relief along the motion"), std::string::npos);
}

TEST(TimeOffset, IsRefusedWhereAOneSidedSlopeCouldBeAShift) {
  // A ramp 0.3 mm lower looks the same as one that comes later.
  const Height ramp = [](double x, double) { return 0.5 * x; };
  Truth truth;
  truth.ramps = false;
  const std::string text = refusal(ramp, truth);
  EXPECT_NE(text.find("time offset: uncertain"), std::string::npos) << text;
  // While the robot stands or is slow, only the shift is visible, which separates the two.
  const TimeOffset found = estimate(ramp, {});
  EXPECT_NEAR(found.pose_delay, truth.delay, 3 * found.uncertainty);
}

TEST(TimeOffset, IsRefusedForScansOfTheSameDirection) {
  try {
    estimate_time_offset(scan(hills, 1, {}, 1), scan(hills, 1, {}, 2));
    FAIL();
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("opposite directions"), std::string::npos);
  }
}

TEST(TimeOffset, IsRefusedForScansOfDifferentPlacesAndForEmptyOnes) {
  Truth away;
  away.scene.translation().x() = 3;
  EXPECT_THROW(estimate_time_offset(scan(hills, 1, {}, 1), scan(hills, -1, away, 2)),
               scan_cell_common::UnusableInput);
  EXPECT_THROW(estimate_time_offset({}, scan(hills, -1, {}, 2)), scan_cell_common::UnusableInput);
  UnboundScan no_poses = scan(hills, 1, {}, 1);
  no_poses.poses.clear();
  EXPECT_THROW(estimate_time_offset(no_poses, scan(hills, -1, {}, 2)),
               scan_cell_common::UnusableInput);
}
