// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "scanner_views/blocks.h"
#include "scanner_views/parts/mesh_builder.h"
#include "surface/mesh_repair.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

Mesh together(Mesh one, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& triangle : other.triangles)
    one.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
  return one;
}

/// A cube of 50 mm in small triangles, centred at `middle` [m].
Mesh cube_at(const Vector3d& middle) {
  const Mesh cube = refined(block(0.05, 0.05, 0.05), 0.01);
  return moved(cube, [&](const Vector3d& at) -> Vector3d {
    // Snaps to a lattice, so that touching cubes have the same vertices.
    const Vector3d steps = ((at + middle) / 1e-6).array().round();
    return 1e-6 * steps;
  });
}

/// The share of samples whose normals point away from the nearest middle.
double share_out(const Surface& surface, const Points& middles) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const auto nearest =
        std::min_element(middles.begin(), middles.end(), [&](const Vector3d& a, const Vector3d& b) {
          return (a - surface.points[i]).squaredNorm() < (b - surface.points[i]).squaredNorm();
        });
    out += surface.normals[i].dot(surface.points[i] - *nearest) > 0;
  }
  return static_cast<double>(out) / static_cast<double>(surface.points.size());
}

const Vector3d kMiddle(0, 0, 0.025);  // of cube_at(0)
const Vector3d kBeside(0.05, 0.05, 0);

}  // namespace

TEST(BrokenMesh, PointsOutWhereTrianglesAreWoundEitherWay) {
  for (const std::size_t each : {2, 3, 7}) {
    const Surface surface = surface_of(wound_otherwise(cube_at({0, 0, 0}), each));
    EXPECT_TRUE(surface.closed) << each;
    EXPECT_EQ(share_out(surface, {kMiddle}), 1) << each;
  }
}

TEST(BrokenMesh, IsClosedWhereTwoBodiesTouchAlongAnEdge) {
  const Surface surface = surface_of(together(cube_at({0, 0, 0}), cube_at(kBeside)));
  EXPECT_TRUE(surface.closed);
  EXPECT_TRUE(surface.oriented);
  EXPECT_EQ(share_out(surface, {kMiddle, kMiddle + kBeside}), 1);
}

TEST(BrokenMesh, PointsOutWhereOneOfTwoBodiesIsInsideOut) {
  const Vector3d apart(0.2, 0, 0);
  const Surface surface = surface_of(together(cube_at({0, 0, 0}), wound_otherwise(cube_at(apart))));
  EXPECT_TRUE(surface.closed);
  EXPECT_EQ(share_out(surface, {kMiddle, kMiddle + apart}), 1);
}

TEST(BrokenMesh, MayHoldTrianglesTwiceAndSomeWithoutAnArea) {
  Mesh mesh = cube_at({0, 0, 0});
  const auto whole = mesh.triangles;
  for (std::size_t i = 0; i < whole.size(); i += 2)
    mesh.triangles.push_back(whole[i]);
  mesh.triangles.push_back({whole[0][0], whole[0][1], whole[0][1]});
  const Surface surface = surface_of(mesh);
  EXPECT_TRUE(surface.closed);
  EXPECT_EQ(share_out(surface, {kMiddle}), 1);
  EXPECT_EQ(repaired(Points(3, kMiddle), {{0, 1, 1}, {0, 1, 2}, {1, 2, 0}}).size(), 1U);
}

TEST(BrokenMesh, IsOpenAndHasNoSidesWhereNothingSaysHowItsPiecesHangTogether) {
  MeshBuilder builder;  // three sheets on one edge
  const Vector3d low(0, 0, 0), high(0, 0, 0.1);
  for (const Vector3d& way : {Vector3d(0.1, 0, 0), Vector3d(-0.1, 0.05, 0), Vector3d(0, 0.1, 0)})
    builder.quad(low, high, high + way, low + way);
  const Surface surface = surface_of(builder.take());
  EXPECT_FALSE(surface.closed);
  EXPECT_FALSE(surface.oriented);
}
