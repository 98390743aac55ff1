// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// What goes is judged by the closed form of each shape, on a lattice whose points nobody rounds.
#include <gtest/gtest.h>

#include <cmath>

#include "cloud_preprocess/cloud_edits.h"
#include "scan_cell_common/errors/errors.h"

namespace cloud_preprocess {
namespace {

constexpr int kHalf = 20;            // lattice steps to each side
constexpr double kStep = 1.0 / 256;  // [m] exact in single precision

/// A cube of points about the origin.
Cloud lattice() {
  Cloud cloud;
  for (int x = -kHalf; x <= kHalf; ++x)
    for (int y = -kHalf; y <= kHalf; ++y)
      for (int z = -kHalf; z <= kHalf; ++z)
        cloud.push_back({static_cast<float>(x * kStep), static_cast<float>(y * kStep),
                         static_cast<float>(z * kStep)});
  return cloud;
}

Cloud edited(Cloud cloud, std::vector<CloudEdit> edits) {
  StageReport report;
  return CloudEdits(std::move(edits)).run(std::move(cloud), report);
}

/// Keep and delete must divide the cloud like the closed form.
template <class Shape, class Truth>
void expect_parted(const Shape& shape, const Truth& is_in) {
  std::size_t inside = 0;
  for (const auto& point : lattice())
    inside += is_in(Eigen::Vector3d(point.getVector3fMap().cast<double>())) ? 1 : 0;
  ASSERT_GT(inside, 0u);
  const Cloud kept = edited(lattice(), {{true, shape}});
  EXPECT_EQ(kept.size(), inside);
  for (const auto& point : kept)
    EXPECT_TRUE(is_in(Eigen::Vector3d(point.getVector3fMap().cast<double>())));
  EXPECT_EQ(edited(lattice(), {{false, shape}}).size(), lattice().size() - inside);
}

TEST(CloudEditsBy, ATurnedBoxPartTheCloudAtItsFaces) {
  BoxShape box;
  box.pose.translation() = Eigen::Vector3d(0.01, -0.007, 0.003);
  box.pose.linear() =
      Eigen::AngleAxisd(0.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  box.size = Eigen::Vector3d(0.06, 0.04, 0.03);
  const Eigen::Matrix3d axes = box.pose.linear();
  expect_parted(box, [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d off = point - box.pose.translation();
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(axes.col(axis).dot(off)) > box.size[axis] / 2) return false;
    return true;
  });
}

TEST(CloudEditsBy, APlanePartTheCloudAndTakeThePlaneWithTheNormalsSide) {
  const HalfSpace half{Eigen::Vector3d(0, 0, 4 * kStep), Eigen::Vector3d::UnitZ()};
  expect_parted(half, [](const Eigen::Vector3d& point) { return point.z() >= 4 * kStep; });
}

TEST(CloudEditsBy, APolygonWithANotchTakeWhatIsBehindItBetweenTwoDepths) {
  // An L in the picture from above; the notch is the quadrant x > 0, y > 0.
  const double far = 10.5 * kStep, middle = 0.5 * kStep;
  const PrismShape prism{{{-far, -far, 0.1},
                          {far, -far, 0.1},
                          {far, middle, 0.1},
                          {middle, middle, 0.1},
                          {middle, far, 0.1},
                          {-far, far, 0.1}},
                         Eigen::Vector3d::UnitZ(),
                         0.1 - 3.5 * kStep,
                         0.1 + 5.5 * kStep};
  expect_parted(prism, [&](const Eigen::Vector3d& point) {
    const bool in_square = std::abs(point.x()) < far && std::abs(point.y()) < far;
    const bool in_notch = point.x() > middle && point.y() > middle;
    return in_square && !in_notch && point.z() < 3.5 * kStep && point.z() > -5.5 * kStep;
  });
}

TEST(CloudEditsBy, ABrushTakeWhatLiesWithinItsRadiusOfAnyPlace) {
  const BrushShape brush{{{0, 0, 0}, {10 * kStep, 0, 0}}, 6.3 * kStep};
  expect_parted(brush, [&](const Eigen::Vector3d& point) {
    return point.norm() <= brush.radius || (point - brush.places[1]).norm() <= brush.radius;
  });
}

TEST(CloudEditsBy, AClusterTakeWhatCanBeReachedByStepsOfItsGap) {
  // Two bars of five points, three steps apart.
  Cloud cloud;
  for (int i = 0; i < 5; ++i)
    cloud.push_back({static_cast<float>(i * kStep), 0, 0});
  for (int i = 7; i < 12; ++i)
    cloud.push_back({static_cast<float>(i * kStep), 0, 0});
  const Eigen::Vector3d place(0.2 * kStep, 0.3 * kStep, 0);
  EXPECT_EQ(edited(cloud, {{true, ClusterShape{place, 2.5 * kStep}}}).size(), 5u);
  EXPECT_EQ(edited(cloud, {{true, ClusterShape{place, 3.5 * kStep}}}).size(), 10u);
  const Eigen::Vector3d away(0, 50 * kStep, 0);
  EXPECT_EQ(edited(cloud, {{false, ClusterShape{away, 2 * kStep}}}).size(), 10u)
      << "nothing is near the place";
}

TEST(CloudEditsInAList, AreDoneOneAfterTheOtherAndTheSourceIsTold) {
  const HalfSpace above{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()};
  const HalfSpace right{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  TracedCloud cloud(lattice());
  StageReport report;
  CloudEdits({{true, above}, {false, right}}).run(cloud, report);
  const std::size_t side = 2 * kHalf + 1;
  EXPECT_EQ(cloud.cloud().size(), std::size_t{kHalf} * side * (kHalf + 1));
  EXPECT_EQ(report.message, "keep plane: 33620 points removed, delete plane: 18081 points removed");
  const Cloud source = lattice();
  for (std::size_t i = 0; i < cloud.cloud().size(); ++i)
    ASSERT_EQ(cloud.cloud()[i].getVector3fMap(), source[cloud.sources()[i]].getVector3fMap());
}

TEST(CloudEditsInAList, ThatLeaveNothingAreRefusedByTheNumberOfTheEdit) {
  const HalfSpace all{Eigen::Vector3d(0, 0, -1), Eigen::Vector3d::UnitZ()};
  try {
    edited(lattice(), {{true, all}, {false, all}});
    ADD_FAILURE() << "an empty cloud came out";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("edit 2 (delete plane)"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace cloud_preprocess
