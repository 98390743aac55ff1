// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cases/case_list.h"
#include "geometry/kd_tree.h"
#include "geometry/points.h"

// The benchmark's truth is only as good as its parts.

namespace {

struct Closed {
  const char* name;
  cases::Part part;
  double volume;  // [m^3] computed by hand
};

/// Sums over the surface, each piece evaluated at its middle.
struct SurfaceSums {
  double area = 0;
  double volume = 0;  // by the divergence theorem: positive if normals point out of the part
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // zero over a closed surface
};

SurfaceSums sums_of(const cases::Part& part) {
  SurfaceSums sums;
  for (const cases::Facet& facet : part.facets) {
    const cases::SurfacePoint middle = facet.at(0.5, 0.5);
    sums.area += facet.area;
    sums.volume += facet.area * middle.position.dot(middle.normal) / 3;
    sums.normal += facet.area * middle.normal;
  }
  return sums;
}

constexpr double kShaftVolume =
    M_PI * (0.040 * 0.015 * 0.015 + 0.050 * 0.018 * 0.018 + 0.070 * 0.025 * 0.025);

std::vector<Closed> closed_parts() {
  // The keyway's volume up to the cylinder: its segment over a chord of 8 mm is added.
  const double half_angle = std::asin(0.004 / 0.025);
  const double segment = 0.025 * 0.025 * (half_angle - 0.5 * std::sin(2 * half_angle));
  const double chord = 0.025 * std::cos(half_angle);
  const double keyway = 0.040 * (0.008 * (chord - 0.021) + segment);
  return {{"bracket", cases::bracket(), 0.060 * 0.008 * (0.120 + 0.072)},
          {"shaft", cases::shaft(false), kShaftVolume},
          {"shaft with keyway", cases::shaft(true), kShaftVolume - keyway}};
}

}  // namespace

TEST(Parts, AreClosedAndAsLargeAsDrawn) {
  for (const Closed& each : closed_parts()) {
    const SurfaceSums sums = sums_of(each.part);
    EXPECT_NEAR(sums.volume, each.volume, 0.002 * each.volume) << each.name;
    EXPECT_LT(sums.normal.norm(), 0.002 * sums.area) << each.name;
  }
}

TEST(Parts, OfAnElbowTheOpenEndAloneIsMissing) {
  const SurfaceSums sums = sums_of(cases::elbow());
  const Eigen::Vector3d missing(0, 0, -M_PI * 0.025 * 0.025);
  EXPECT_LT((sums.normal + missing).norm(), 0.002 * sums.area);
}

TEST(Cases, HaveTheirPathsOnTheSurfaceWithTheToolAlongTheNormal) {
  for (const cases::Case& each : cases::all_cases("")) {
    cases::Scan dense;
    dense.points = 40000;
    dense.noise = 0;
    const tool_path_stretcher::KdTree tree(cases::scan(each.reference, cases::none(), {}, dense));
    for (const auto& waypoint : each.reference.path.segments.at(0).waypoints) {
      const Eigen::Vector3d at = waypoint.pose.translation();
      const Eigen::Vector3d off = tree.points()[tree.nearest(at).index] - at;
      EXPECT_LT(off.norm(), 0.005) << each.name;
      EXPECT_LT(std::abs(off.dot(waypoint.pose.linear().col(2))), 0.0015) << each.name;
    }
  }
}

TEST(Cases, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const cases::Case& each : cases::all_cases(""))
    EXPECT_TRUE(names.insert(each.name).second) << each.name;
}
