// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "local_surface/strangers.h"
#include "scanner_views/blocks.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

constexpr double kHalf = 0.05, kStep = 0.001;  // [m]
constexpr double kMaxOff = 0.004, kRadius = 0.003;
const Vector3d kUp = Vector3d::UnitZ();

void add_square(const Vector3d& middle, double half, Points& points) {
  for (double x = -half; x <= half; x += kStep) {
    for (double y = -half; y <= half; y += kStep)
      points.push_back(middle + Vector3d(x, y, 0));
  }
}

Surface scan_of(const Points& points) {
  return surface_from_cloud(points, Vector3d::Constant(kStep / 10), "scan");
}

/// The face of a part, z = 0, and a patch over or under it in the scan of another part.
class AStranger : public testing::Test {
 protected:
  /// @param height [m] of the patch
  /// @param is_seen whether the face itself was seen under the patch
  std::size_t points_beside_path(const Surface& reference, double height, const Points& seen_from,
                                 bool is_seen = false) const {
    Points points;
    add_square(Vector3d::Zero(), kHalf, points);
    add_square({0, 0, height}, 0.006, points);
    Surface object = scan_of(points);
    object.seen_from = seen_from;
    const SurfacePair surfaces{reference, object};
    const Mapping mapping;
    const Strangers strangers(surfaces, mapping, residuals_of(reference, mapping, object.points),
                              kMaxOff);
    return strangers.beside(Vector3d::Zero(), kUp, kRadius, is_seen).points;
  }

  Surface scanned_face() const {
    Points points;
    add_square(Vector3d::Zero(), kHalf, points);
    return scan_of(points);
  }

  Surface mesh_face() const {
    Mesh mesh = block(2 * kHalf, 2 * kHalf, 0.02);
    for (Vector3d& vertex : mesh.vertices)
      vertex.z() -= 0.02;
    return surface_of(mesh);
  }
};

}  // namespace

TEST_F(AStranger, OverThePathIsOneWhateverTheReference) {
  EXPECT_GT(points_beside_path(scanned_face(), 0.008, {kUp}), 10U);
  EXPECT_GT(points_beside_path(mesh_face(), 0.008, {kUp}), 10U);
}

TEST_F(AStranger, HighOverThePathIsOneWhereTheScannerLookedDownOnIt) {
  constexpr double kHigh =
      0.08;  // [m] of a part of 0.1 m: the top of a rib, whose sides were not seen
  EXPECT_GT(points_beside_path(scanned_face(), kHigh, {kUp}), 5U);
  EXPECT_GT(points_beside_path(mesh_face(), kHigh, {kUp}), 5U);
  EXPECT_EQ(points_beside_path(mesh_face(), kHigh, {Vector3d::UnitX()}), 0U);
  EXPECT_EQ(points_beside_path(mesh_face(), kHigh, {kUp}, true), 0U)
      << "a clamp beside the path: what stands on it would hide it";
  EXPECT_EQ(points_beside_path(mesh_face(), 0.2, {kUp}), 0U) << "farther than the part is long";
  EXPECT_EQ(points_beside_path(mesh_face(), -kHigh, {kUp}), 0U) << "the floor through a hole";
}

TEST_F(AStranger, UnderThePathMayBeWhatTheReferencesScanDidNotShow) {
  EXPECT_EQ(points_beside_path(scanned_face(), -0.008, {kUp}), 0U);
}

TEST_F(AStranger, UnderThePathIsOneWhereTheReferenceShowsAll) {
  EXPECT_GT(points_beside_path(mesh_face(), -0.008, {kUp}), 10U);
}

TEST_F(AStranger, UnderThePathIsOneWhereNobodySaysFromWhichSideItWasSeen) {
  EXPECT_GT(points_beside_path(scanned_face(), -0.008, {}), 10U);
  EXPECT_GT(points_beside_path(scanned_face(), -0.008, {Vector3d::UnitX()}), 10U);
}
