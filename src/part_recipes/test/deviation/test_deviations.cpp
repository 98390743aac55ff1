// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "deviation/deviations.h"
#include "deviation/statistics.h"
#include "drawn_surfaces.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/errors/errors.h"

using drawn::Points;
using Eigen::Vector3d;
using part_recipes::OutsideKnownBy;
using part_recipes::ReferenceSurface;

namespace {

constexpr double kTolerance = 0.0005;  // [m]
constexpr double kExact = 2e-7;        // [m]: places are floats in the files

/// Where the points of a reference lie on the object.
Points on_object(const Points& points) {
  Points result;
  for (const Vector3d& point : points)
    result.push_back(drawn::moved() * point);
  return result;
}

std::vector<double> deviations_of(const ReferenceSurface& reference, const Points& on_reference) {
  return measure(reference, drawn::moved(), on_object(on_reference), kTolerance).values;
}

/// Points inside the plane's border, lifted by a height that is `lift` on the object.
Points lifted(double lift) {
  Points points;
  for (const Vector3d& point : drawn::plane(0.0013))
    points.push_back(0.95 * point + lift / drawn::moved().scale * Vector3d::UnitZ());
  return points;
}

void expect_all(const std::vector<double>& values, double expected, double error) {
  ASSERT_FALSE(values.empty());
  for (const double value : values)
    ASSERT_NEAR(value, expected, error);
}

}  // namespace

TEST(Deviations, OfALiftedPlaneAreItsLift) {
  const drawn::Folder folder;
  const auto reference = ReferenceSurface::load(folder.save("plane.ply", drawn::plane()), 1);
  EXPECT_EQ(reference->outside_known_by(), OutsideKnownBy::kUpwards);
  for (const double lift : {0.0003, -0.0003, 0.002, -0.002})
    expect_all(deviations_of(*reference, lifted(lift)), lift, kExact);
}

TEST(Deviations, OfAReferenceInMillimetresAreTheSame) {
  const drawn::Folder folder;
  Points millimetres;
  for (const Vector3d& point : drawn::plane())
    millimetres.push_back(1000 * point);
  const auto reference = ReferenceSurface::load(folder.save("plane.ply", millimetres), 0.001);
  expect_all(deviations_of(*reference, lifted(0.0003)), 0.0003, kExact);
}

TEST(Deviations, OfAScannedSphereAreTheGrowthOfItsRadius) {
  constexpr double kRadius = 0.05, kGrid = 1e-5;  // [m]: a cell's mean lies 1/8 mm^2 / 50 mm inside
  const drawn::Folder folder;
  const auto reference =
      ReferenceSurface::load(folder.save("cap.ply", drawn::cap(kRadius, 40000)), 1);
  for (const double growth : {0.0004, -0.0004, 0.003}) {
    Points grown;
    for (const Vector3d& point : drawn::cap(kRadius + growth / drawn::moved().scale, 7000)) {
      if (point.z() > 0.7 * kRadius) grown.push_back(point);  // away from the rim
    }
    expect_all(deviations_of(*reference, grown), growth, kGrid);
  }
}

TEST(Deviations, OfAClosedMeshArePositiveOutsideWhateverItsWinding) {
  constexpr double kRadius = 0.05, kChord = 1e-5;  // [m] of the triangles: 8 um below the sphere
  const drawn::Folder folder;
  for (const bool inside_out : {false, true}) {
    drawn::save_sphere(folder / "sphere.stl", kRadius, inside_out);
    const auto reference = ReferenceSurface::load(folder / "sphere.stl", 1);
    EXPECT_EQ(reference->outside_known_by(), OutsideKnownBy::kClosedMesh);
    for (const double growth : {0.0004, -0.0004}) {
      const Points grown = drawn::cap(kRadius + growth / drawn::moved().scale, 3000);
      expect_all(deviations_of(*reference, grown), growth, kChord);
    }
  }
}

TEST(Deviations, AtTheEdgesOfAMeshAreDistancesFromItsTriangles) {
  const drawn::Folder folder;
  drawn::save_cube(folder / "cube.stl", 0.04);
  const auto reference = ReferenceSurface::load(folder / "cube.stl", 1);
  const part_recipes::Reach reach{0.01, 0.001};
  const auto distance = [&](const Vector3d& point) {
    return reference->signed_distance(point, reach);
  };
  EXPECT_NEAR(distance({0.0199, 0, 0.021}), 0.001, kExact);     // above a face, next to its edge
  EXPECT_NEAR(distance({0.0199, 0, 0.0195}), -0.0001, kExact);  // below it, nearer to the side
  EXPECT_NEAR(distance({0.023, 0, 0.024}), 0.005, kExact);      // off an edge: 3, 4 and 5 mm
  EXPECT_NEAR(distance({0.021, 0.022, 0.022}), 0.003, kExact);  // off a corner: 1, 2, 2 and 3 mm
  EXPECT_NEAR(distance({0, 0, 0.015}), -0.005, kExact);
}

TEST(Deviations, AreUnknownWhereNoSurfaceIsNear) {
  const drawn::Folder folder;
  drawn::save_sheet(folder / "square.stl", 0.1, 1, false);
  const auto mesh = ReferenceSurface::load(folder / "square.stl", 1);
  EXPECT_EQ(mesh->outside_known_by(), OutsideKnownBy::kUpwards);
  Points holed;  // of 20 mm
  for (const Vector3d& point : drawn::plane()) {
    if (point.norm() > 0.01) holed.push_back(point);
  }
  const auto cloud = ReferenceSurface::load(folder.save("holed.ply", holed), 1);
  const part_recipes::Reach reach{0.005, 0.001};
  EXPECT_TRUE(std::isnan(cloud->signed_distance({0, 0, 0.0001}, reach)));
  EXPECT_FALSE(std::isnan(cloud->signed_distance({0.012, 0, 0.0001}, reach)));
  for (const auto* reference : {mesh.get(), cloud.get()}) {
    EXPECT_TRUE(std::isnan(reference->signed_distance({0.03, 0, 0.006}, reach)));    // above
    EXPECT_TRUE(std::isnan(reference->signed_distance({0.053, 0, 0.0001}, reach)));  // beyond
  }
  EXPECT_NEAR(mesh->signed_distance({0.0505, 0, -0.0002}, reach), -0.0002, kExact);
}

TEST(Deviations, OfAFineOpenMeshArePositiveUpwardsWhateverItsWinding) {
  const drawn::Folder folder;
  for (const bool downwards : {false, true}) {
    drawn::save_sheet(folder / "sheet.stl", 0.1, 150, downwards);
    const auto sheet = ReferenceSurface::load(folder / "sheet.stl", 1);
    EXPECT_EQ(sheet->outside_known_by(), OutsideKnownBy::kUpwards);
    EXPECT_NEAR(sheet->signed_distance({0.0113, 0.0207, 0.0003}, {0.005, 0.001}), 0.0003, kExact);
  }
}

TEST(Deviations, AreUnknownWhereNothingTellsTheOutside) {
  const drawn::Folder folder;
  Points wall;
  for (const Vector3d& point : drawn::plane())
    wall.emplace_back(0, point.x(), point.y());
  const auto reference = ReferenceSurface::load(folder.save("wall.ply", wall), 1);
  EXPECT_TRUE(std::isnan(reference->signed_distance({0.0002, 0, 0}, {0.005, 0.001})));
}

TEST(Deviations, TakeTheSideThatTheScannerSawForOutside) {
  const drawn::Folder folder;
  scan_cell_common::FieldedCloud cloud;
  for (const char* name : {"x", "y", "z", "vp_x", "vp_y", "vp_z"}) {
    cloud.fields.push_back({name, scan_cell_common::FieldType::kFloat32, cloud.step});
    cloud.step += sizeof(float);
  }
  for (const Vector3d& point : drawn::plane()) {
    const float values[] = {
        static_cast<float>(point.x()), static_cast<float>(point.y()), 0, 0, 0, -0.5F};
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values);
    cloud.bytes.insert(cloud.bytes.end(), bytes, bytes + sizeof(values));
  }
  save_cloud(folder / "below.ply", cloud.view());
  const auto reference = ReferenceSurface::load(folder / "below.ply", 1);
  EXPECT_EQ(reference->outside_known_by(), OutsideKnownBy::kViewpoints);
  expect_all(deviations_of(*reference, lifted(0.0003)), -0.0003, kExact);
}

TEST(Deviations, SmoothTheNoiseOfAScannedReference) {
  constexpr double kNoise = 0.0001;  // [m]
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, kNoise);
  Points noisy = drawn::plane(0.0005);
  for (Vector3d& point : noisy)
    point.z() += noise(random);
  const drawn::Folder folder;
  const auto reference = ReferenceSurface::load(folder.save("noisy.ply", noisy), 1);
  const auto statistics =
      part_recipes::statistics_of(deviations_of(*reference, lifted(0)), kTolerance);
  EXPECT_EQ(statistics.unknown, 0U);
  EXPECT_LT(*statistics.rms, kNoise / 2);
  EXPECT_NEAR(*statistics.median, 0, kNoise / 20);
}

TEST(Deviations, OfPointsThatAreNotFiniteAreRefused) {
  const drawn::Folder folder;
  const auto reference = ReferenceSurface::load(folder.save("plane.ply", drawn::plane()), 1);
  Points object = lifted(0);
  object[7].y() = NAN;
  EXPECT_THROW(measure(*reference, {}, object, kTolerance), scan_cell_common::UnusableInput);
  EXPECT_THROW(measure(*reference, {}, Points(3, Vector3d::Zero()), kTolerance),
               scan_cell_common::UnusableInput);
}

TEST(Unscanned, ShareIsThatOfTheSurfaceWithoutPoints) {
  const drawn::Folder folder;
  const auto reference = ReferenceSurface::load(folder.save("plane.ply", drawn::plane()), 1);
  Points three_quarters;
  for (const Vector3d& point : lifted(0.001)) {
    if (point.x() < 0.025) three_quarters.push_back(drawn::moved() * point);
  }
  const double spacing = part_recipes::spacing_of(three_quarters);
  EXPECT_NEAR(spacing, 0.0013 * 0.95 * drawn::moved().scale, 0.0002);
  const auto near = scanned(reference->samples(), drawn::moved(), three_quarters,
                            part_recipes::reach_of(kTolerance, spacing));
  constexpr double kBorder = 0.04;  // two spacings around, of 100 x 60 mm
  EXPECT_NEAR(part_recipes::unscanned_share(near), 0.25, kBorder);
}
