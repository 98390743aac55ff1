// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scanner_views/blocks.h"
#include "scanner_views/case_list.h"
#include "scanner_views/figures/outcome.h"
#include "scanner_views/parts/mesh_builder.h"
#include "sight/seeable.h"
#include "tool_path_stretcher/seen_from.h"
#include "tool_path_stretcher/stretcher.h"

using namespace scanner_views;
using namespace tool_path_stretcher;
using Eigen::Vector3d;

namespace {

const Vector3d kAbove = Vector3d::UnitZ();

/// A ball of 100 mm.
/// @param cracked its first and last line differ in the last bit
Mesh ball(bool cracked = false) {
  constexpr int kSteps = 32;
  const auto at = [](int i, int k) {
    const double polar = M_PI * i / kSteps;
    const double round = 2 * M_PI * k / kSteps;
    return Vector3d(0.05 * Vector3d(std::sin(polar) * std::cos(round),
                                    std::sin(polar) * std::sin(round), std::cos(polar)));
  };
  MeshBuilder builder;
  for (int i = 0; i < kSteps; ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const int next = cracked ? k + 1 : (k + 1) % kSteps;
      builder.quad(at(i, k), at(i + 1, k), at(i + 1, next), at(i, next));
    }
  }
  return builder.take();
}

/// An open sheet of 200 mm x 100 mm in small cells: one edge in a hundred has no neighbour.
Mesh fine_sheet() {
  constexpr int kColumns = 400, kRows = 200;
  const auto at = [](int column, int row) { return Vector3d(0.0005 * column, 0.0005 * row, 0); };
  MeshBuilder builder;
  for (int c = 0; c < kColumns; ++c) {
    for (int r = 0; r < kRows; ++r)
      builder.quad(at(c, r), at(c + 1, r), at(c + 1, r + 1), at(c, r + 1));
  }
  return builder.take();
}

/// Counts points inside the outline of the upper block, between two heights [m], that face the
/// direction.
std::ptrdiff_t count(const Surface& surface, double low, double high,
                     const Vector3d& facing = Vector3d::Zero()) {
  std::ptrdiff_t found = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Vector3d& point = surface.points[i];
    const bool is_face = std::abs(surface.normals[i].z()) > 0.5;
    const bool is_inside = std::abs(point.x()) < 0.019 && std::abs(point.y()) < 0.029;
    if ((is_face && !is_inside) || point.z() < low || point.z() > high) continue;
    if (!is_face && (low > 0.0395 || high < 0.001)) continue;  // walls beside the face
    found += facing.isZero() || surface.normals[i].dot(facing) > 0.99;
  }
  return found;
}

View view_of_case(const std::string& name, unsigned seed = 1) {
  for (const ViewCase& each : all_cases(seed, "")) {
    if (each.family + ": " + each.name() == name) return view_of(each);
  }
  throw std::invalid_argument(name);
}

/// Expects acceptance, with every waypoint within 1 mm of the truth along the normal and 5 mm in
/// total.
void expect_right(const std::string& name, unsigned seed = 1) {
  SCOPED_TRACE(name);
  const View view = view_of_case(name, seed);
  const Answer answer = run_ours(view);
  ASSERT_TRUE(answer.accepted) << answer.message;
  const Errors errors = errors_of(answer, view.truth);
  EXPECT_LT(errors.worst_normal, kWrongNormal);
  EXPECT_LT(errors.worst_position, kWrongPosition);
}

}  // namespace

TEST(SeenFrom, AreTheDirectionsThatDiffer) {
  Points points, viewers;
  for (int i = 0; i < 100; ++i) {
    points.emplace_back(0.001 * i, 0, 0);
    viewers.push_back(points.back() + Vector3d(0, i % 2 == 0 ? 0.3 : -0.3, 0.4));
  }
  points.emplace_back(0, 0, 0);
  viewers.emplace_back(0.5, 0, 0);  // one of a hundred
  const Points directions = directions_seen_from(points, viewers);
  ASSERT_EQ(directions.size(), 2U);
  EXPECT_TRUE(directions[0].isApprox(Vector3d(0, 0.6, 0.8), 1e-9));
  EXPECT_TRUE(directions[1].isApprox(Vector3d(0, -0.6, 0.8), 1e-9));
}

TEST(SeenFrom, IsNotKnownOfCloudsThatDoNotSay) {
  EXPECT_TRUE(directions_seen_from(scan_cell_common::CloudView{}).empty());
}

TEST(ClosedMesh, PointsOutWhateverItsWinding) {
  for (const Mesh& mesh : {step(), wound_otherwise(step())}) {
    const Surface surface = surface_of(mesh);
    EXPECT_TRUE(surface.closed);
    EXPECT_EQ(count(surface, 0.0399, 1, kAbove), count(surface, 0.0399, 1));
    EXPECT_EQ(count(surface, -1, 1e-9, -kAbove), count(surface, -1, 1e-9));
  }
}

TEST(ClosedMesh, IsNoneWhereAFaceIsOpen) {
  Mesh mesh = step();
  const auto is_underside = [&mesh](const auto& triangle) {
    return std::all_of(triangle.begin(), triangle.end(),
                       [&mesh](auto corner) { return mesh.vertices[corner].z() < 1e-6; });
  };
  mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), is_underside),
                       mesh.triangles.end());
  EXPECT_FALSE(surface_of(mesh).closed);
}

TEST(ClosedMesh, IsNoneHoweverFinelyAnOpenSheetIsTriangulated) {
  EXPECT_FALSE(surface_of(fine_sheet()).closed);
}

TEST(ClosedMesh, MayHaveASmallHoleAndACrack) {
  Mesh holed = ball();
  holed.triangles.resize(holed.triangles.size() - 1);
  EXPECT_TRUE(surface_of(holed).closed);
  EXPECT_TRUE(surface_of(ball(true)).closed);
}

TEST(SeeablePart, IsAllButTheUndersideFromAbove) {
  const Surface whole = surface_of(step());
  const Surface part = seeable_part(whole, {kAbove});
  EXPECT_EQ(count(part, -1, 1e-9), 0);
  EXPECT_EQ(count(part, 0.0399, 1), count(whole, 0.0399, 1));
  EXPECT_GT(count(whole, 0.0399, 1), 300);
  EXPECT_EQ(count(part, 0.025, 0.039), count(whole, 0.025, 0.039));  // walls
}

TEST(SeeablePart, LacksWhatAnotherPartOfItHides) {
  // From 45 degrees beside it the upper block, 30 mm high, hides 30 mm of the lower one's face.
  const Surface part = seeable_part(surface_of(step()), {Vector3d(1, 0, 1).normalized()});
  const auto is_on_face = [](const Vector3d& point) {
    return std::abs(point.z() - 0.01) < 1e-6 && std::abs(point.y()) < 0.02;
  };
  std::size_t lit = 0, dark = 0;
  for (const Vector3d& point : part.points) {
    if (!is_on_face(point)) continue;
    lit += point.x() > 0.025;
    dark += point.x() < -0.025 && point.x() > -0.033;
  }
  EXPECT_GT(lit, 100U);
  EXPECT_EQ(dark, 0U);
}

TEST(SeeablePart, EndsAtEdgesOfABlockAndAtTheHorizonOfABall) {
  const Surface cuboid = seeable_part(surface_of(block(0.1, 0.06, 0.03)), {kAbove});
  const Surface round = seeable_part(surface_of(ball()), {kAbove});
  const auto on_horizon = [](const Surface& surface) {
    const auto& horizon = surface.rim.horizon;
    return std::count(horizon.begin(), horizon.end(), true);
  };
  EXPECT_GT(cuboid.rim.points.size(), 100U);
  EXPECT_LT(on_horizon(cuboid), 5);
  EXPECT_GT(round.rim.points.size(), 20U);
  EXPECT_EQ(static_cast<std::size_t>(on_horizon(round)), round.rim.points.size());
}

TEST(SeeablePart, EndsAtARimWhereTheSurfaceItselfEnds) {
  const Rim rim = seeable_part(surface_of(fine_sheet()), {kAbove}).rim;
  EXPECT_GT(rim.points.size(), 100U);
  EXPECT_EQ(std::count(rim.horizon.begin(), rim.horizon.end(), true), 0);
}

TEST(OpenReferences, AreHeldByTheirRimsHoweverFinelyTheyAreTriangulated) {
  expect_right("own path: sanded sheet, moved, whole path");
  expect_right("own path: sanded sheet, bent, whole path");
}

TEST(ClosedReferences, AreLaidOnTheFaceThatWasSeen) {
  expect_right("moved: hat profile, moved");
  expect_right("moved: dished cover, moved");
  expect_right("moved: saddle shell, moved");
}

TEST(ClosedReferences, NeedNotBeSeenFromAllSides) {
  expect_right("moved: pipe elbow, moved");
  expect_right("moved: ribbed bracket, moved");
}

TEST(ClosedReferences, OfAProfileSlideOnToWhereItFits) {
  expect_right("moved: wedge, moved", 2);
}

TEST(ClosedReferences, OfABentPartSlideOnToWhereTheyFitAndAreBentAnew) {
  expect_right("bent: saddle shell, bent", 3);
  expect_right("bent: saddle shell, bent", 4);  // previously, no bend was found at all
}

TEST(ScannedReferences, TiltNoToolWhereAnEdgeIsOnlyRoundedOff) {
  expect_right("scaled, scan as reference: stepped block, scaled, scan as reference");
}

TEST(ClosedReferences, OfAGearAreNotLaidOnTheWrongTeeth) {
  const View view = view_of_case("dented: gear plate, dented");
  const Answer answer = run_ours(view);
  EXPECT_TRUE(!answer.accepted || !errors_of(answer, view.truth).wrong());
}

TEST(ClosedReferences, OfAPlateAreNotTurnedOver) {
  expect_right("moved: slotted plate, moved");
}

TEST(ClosedReferences, OfTheOtherHandAreRefusedThoughAViewHidesOtherSidesOfThem) {
  EXPECT_EQ(run_ours(view_of_case("to refuse: mounting base, mirrored", 8)).verdict,
            "mirrored_part");
}

TEST(ClosedReferences, AreRefusedForARibAcrossThePathOfWhichOnlyTheTopIsSeen) {
  EXPECT_EQ(run_ours(view_of_case(
                         "to refuse: ribbed bracket with one rib elsewhere, for ribbed bracket", 8))
                .verdict,
            "wrong_part");
}
