// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"

using namespace tool_path_stretcher;
using synthetic::Part;

namespace {

constexpr std::size_t kWaypoints = 200;

/// A moulding of 240 x 50 mm, constant along x, with the path along the crest.
Part straight_moulding() {
  Part part;
  part.width = 0.24;
  part.depth = 0.05;
  part.inside = [](double x, double y) { return std::abs(x) <= 0.12 && std::abs(y) <= 0.025; };
  part.height = [](double, double y) { return 0.018 * std::cos(50 * y) + 0.1 * y; };
  part.path_position = [height = part.height](double a) {
    const double x = 0.2 * (a - 0.5);
    return Eigen::Vector3d(x, 0.002, height(x, 0.002));
  };
  return part;
}

struct Case {
  Part part = synthetic::curved_panel();
  Similarity moved = synthetic::similarity(1.1, synthetic::random_rotation(3), {0.2, -0.1, 0.3});
  synthetic::Deformation deformation = synthetic::no_deformation();
  synthetic::Scan scan;
  StretchParameters parameters;

  ToolPath path() const { return synthetic::path_on(part, kWaypoints); }
  ToolPath truth() const { return synthetic::truth(path(), moved, deformation); }

  StretchResult run() const {
    synthetic::Scan whole;
    whole.seed = 11;
    const Points reference = synthetic::scan(part, {}, synthetic::no_deformation(), whole);
    const Points object = synthetic::scan(part, moved, deformation, scan);
    return stretch(surface_from_cloud(reference, parameters.leaf, "reference"),
                   surface_from_cloud(object, parameters.leaf, "object"), path(), parameters);
  }
};

/// The real error of a waypoint over the expected one.
struct Ratio {
  double normal;
  double tangential;
  double orientation;
};

std::vector<Ratio> ratios_of(const StretchResult& result, const ToolPath& truth) {
  std::vector<Ratio> ratios;
  for (const WaypointQuality& quality : result.quality) {
    const auto pose = [&quality](const ToolPath& path) {
      return path.segments.at(quality.segment).waypoints.at(quality.waypoint).pose;
    };
    const Eigen::Vector3d normal = pose(truth).linear().col(2);
    const Eigen::Vector3d off = pose(result.path).translation() - pose(truth).translation();
    const double along = normal.dot(off);
    const Eigen::Matrix3d turn = pose(truth).linear().transpose() * pose(result.path).linear();
    const double turned = Eigen::AngleAxisd(turn).angle();
    ratios.push_back({std::abs(along) / quality.expected_error_normal,
                      (off - along * normal).norm() / quality.expected_error_tangential,
                      turned / quality.expected_error_orientation});
  }
  return ratios;
}

double median(const std::vector<Ratio>& ratios, double Ratio::*which) {
  std::vector<double> values;
  for (const Ratio& ratio : ratios)
    values.push_back(ratio.*which);
  std::sort(values.begin(), values.end());
  return values.at(values.size() / 2);
}

/// Expects nearly all errors to be less than three times the expected ones, but not only a small
/// part of them.
void expect_calibrated(const Case& each) {
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  const std::vector<Ratio> ratios = ratios_of(result, each.truth());
  const auto beyond = std::count_if(ratios.begin(), ratios.end(), [](const Ratio& ratio) {
    return !(ratio.normal <= 3) || !(ratio.tangential <= 3) || !(ratio.orientation <= 3);
  });
  EXPECT_LE(beyond, static_cast<std::ptrdiff_t>(ratios.size() / 20));
  EXPECT_GT(median(ratios, &Ratio::normal), 0.1);
  EXPECT_GT(median(ratios, &Ratio::tangential), 0.1);
  EXPECT_GT(median(ratios, &Ratio::orientation), 0.01);
}

}  // namespace

TEST(ExpectedError, HoldsOnARigidPanel) {
  expect_calibrated({});
}

TEST(ExpectedError, HoldsOnABentPanel) {
  Case each;
  each.deformation = synthetic::bend(0.004, 0.300);
  expect_calibrated(each);
}

TEST(ExpectedError, HoldsInADent) {
  Case each;
  each.deformation = [](const Eigen::Vector3d& at) {
    const double away = std::hypot(at.x() - 0.02, at.y() - 0.02) / 0.015;
    return Eigen::Vector3d(0, 0, -0.001 * std::exp(-away * away));
  };
  expect_calibrated(each);
}

TEST(ExpectedError, GrowsOverAHole) {
  Case each;
  each.part = synthetic::photo_frame();
  each.scan.is_hole = [](const Eigen::Vector3d& at) {
    return at.y() < -0.05 && std::abs(at.x()) < 0.008;
  };
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  std::vector<double> measured;
  const WaypointQuality* middle = nullptr;
  for (const WaypointQuality& quality : result.quality) {
    if (quality.measured) measured.push_back(quality.expected_error_normal);
    if (!quality.measured && (middle == nullptr || quality.hole > middle->hole)) middle = &quality;
  }
  ASSERT_NE(middle, nullptr);
  std::sort(measured.begin(), measured.end());
  EXPECT_GT(middle->expected_error_normal, measured.at(measured.size() / 2));
}

TEST(ExpectedError, OfAMouldingWithBothEndsScannedIsLargestAlongIt) {
  Case each;
  each.part = straight_moulding();
  expect_calibrated(each);
  const StretchResult result = each.run();
  for (const WaypointQuality& quality : result.quality) {
    const Eigen::Vector3d along = each.moved.rotation * Eigen::Vector3d::UnitX();
    EXPECT_GT(std::abs(quality.least_known.dot(along)), 0.8);
    EXPECT_GT(quality.expected_error_tangential, 1.5 * quality.expected_error_across);
  }
}

TEST(ExpectedError, SaysThatAMouldingWithoutEndsIsNotKnownAlongItself) {
  Case each;
  each.part = straight_moulding();
  each.moved.scale = 1;
  // The path ends at 0.1 m, and may slide by as much as the prior allows.
  each.scan.is_hole = [](const Eigen::Vector3d& at) { return std::abs(at.x()) > 0.107; };
  PosePrior about;
  about.pose.linear() = each.moved.rotation;
  about.pose.translation() = each.moved.translation + Eigen::Vector3d(0.002, -0.001, 0.001);
  about.distance = 0.005;
  about.angle = 0.2;
  each.parameters.prior = {{1, 0}, about};
  const StretchResult result = each.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  for (const Ratio& ratio : ratios_of(result, each.truth()))
    EXPECT_LE(ratio.tangential, 3);
  for (const WaypointQuality& quality : result.quality) {
    EXPECT_FALSE(quality.position_measured);
    EXPECT_GT(quality.expected_error_tangential, 0.001);
    EXPECT_LT(quality.expected_error_across, 0.0003);
    EXPECT_LT(quality.expected_error_normal, 0.0003);
    const Eigen::Vector3d along = each.moved.rotation * Eigen::Vector3d::UnitX();
    EXPECT_GT(std::abs(quality.least_known.dot(along)), 0.98);
  }
}
