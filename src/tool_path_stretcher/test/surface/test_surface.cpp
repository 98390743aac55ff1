// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/conversions.h>

#include <cmath>
#include <limits>
#include <random>

#include "geometry/points.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "surface/surface_targets.h"
#include "synthetic_parts.h"
#include "tool_path_stretcher/surface.h"

using namespace tool_path_stretcher;
using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

namespace {

const Eigen::Vector3d kLeaf(0.002, 0.002, 0.0005);

pcl::PolygonMesh mesh_of(const std::vector<pcl::PointXYZ>& vertices,
                         const std::vector<std::vector<std::uint32_t>>& triangles) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const pcl::PointXYZ& vertex : vertices)
    cloud.push_back(vertex);
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  for (const auto& triangle : triangles) {
    pcl::Vertices polygon;
    polygon.vertices.assign(triangle.begin(), triangle.end());
    mesh.polygons.push_back(polygon);
  }
  return mesh;
}

Points plane(std::size_t across, double step) {
  Points points;
  for (std::size_t x = 0; x < across; ++x) {
    for (std::size_t y = 0; y < across; ++y) {
      points.emplace_back(step * static_cast<double>(x), step * static_cast<double>(y), 0);
    }
  }
  return points;
}

}  // namespace

TEST(GridReduction, LeavesTheMeanOfEachCell) {
  const Points reduced = reduce_on_grid({{0.0001, 0.0001, 0.0001},
                                         {0.0015, 0.0005, 0.0003},
                                         {0.0021, 0.0005, 0.0003},
                                         {0.0001, 0.0001, 0.0006},
                                         {-0.0001, 0.0001, 0.0001}},
                                        kLeaf);
  ASSERT_EQ(reduced.size(), 4U);
  EXPECT_TRUE(reduced[0].isApprox(Eigen::Vector3d(-0.0001, 0.0001, 0.0001)));
  EXPECT_TRUE(reduced[1].isApprox(Eigen::Vector3d(0.0008, 0.0003, 0.0002)));
  EXPECT_TRUE(reduced[2].isApprox(Eigen::Vector3d(0.0001, 0.0001, 0.0006)));
  EXPECT_TRUE(reduced[3].isApprox(Eigen::Vector3d(0.0021, 0.0005, 0.0003)));
}

TEST(GridReduction, IsNotDefeatedByOneFarOutlier) {
  Points points = plane(100, 0.0005);  // 16 points a cell
  const std::size_t without = reduce_on_grid(points, kLeaf).size();
  points.emplace_back(5000, -5000, 5000);  // pcl::VoxelGrid returns such a cloud unreduced
  EXPECT_EQ(without, 625U);
  EXPECT_EQ(reduce_on_grid(points, kLeaf).size(), without + 1);
}

TEST(GridReduction, RefusesWhatItCannotCount) {
  EXPECT_THROW(reduce_on_grid({{1e300, 0, 0}}, kLeaf), UnusableInput);
  EXPECT_THROW(reduce_on_grid({{std::nan(""), 0, 0}}, kLeaf), UnusableInput);
  EXPECT_THROW(reduce_on_grid({{0, 0, 0}}, {0.002, 0, 0.0005}), InvalidParameter);
}

TEST(SpreadEvenly, TakesAsManyFromSparseAreasAsFromDenseOnes) {
  Points points = plane(50, 0.01);  // the half metre square at the origin
  for (const Eigen::Vector3d& point : plane(200, 0.0025))
    points.push_back(point + Eigen::Vector3d(1, 0, 0));  // equally large, sixteen times as dense
  const std::vector<std::size_t> chosen = spread_evenly(points, 1000);
  EXPECT_LE(chosen.size(), 1000U);
  EXPECT_GE(chosen.size(), 700U);
  const auto sparse =
      std::count_if(chosen.begin(), chosen.end(), [](std::size_t index) { return index < 2500; });
  EXPECT_NEAR(static_cast<double>(sparse) / static_cast<double>(chosen.size()), 0.5, 0.05);
}

TEST(MeshSurface, IsSampledByAreaNotByVertices) {
  // Two triangles with areas in the ratio 1 : 9, in different planes.
  const auto mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {3, 0, 2}, {0, 3, 2}},
                            {{0, 1, 2}, {3, 4, 5}});
  const Surface surface = surface_from_mesh(mesh, kLeaf, "mesh");
  std::size_t low = 0;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Eigen::Vector3d& point = surface.points[i];
    const double edge = point.z() == 0 ? 1 : 3;
    ASSERT_TRUE(point.z() == 0 || point.z() == 2);
    ASSERT_TRUE(point.x() >= 0 && point.y() >= 0 && point.x() + point.y() <= edge + 1e-6);
    ASSERT_TRUE(surface.normals[i].isApprox(Eigen::Vector3d::UnitZ()));
    if (point.z() == 0) ++low;
  }
  EXPECT_NEAR(static_cast<double>(low) / static_cast<double>(surface.points.size()), 0.1, 0.001);
  // No quarter of the large triangle is favoured.
  const auto corner =
      std::count_if(surface.points.begin(), surface.points.end(),
                    [](const Eigen::Vector3d& p) { return p.z() == 2 && p.x() + p.y() <= 1.5; });
  EXPECT_NEAR(static_cast<double>(corner) / static_cast<double>(surface.points.size()), 0.225,
              0.005);
}

TEST(MeshSurface, IsRefusedWithoutAreaOrWithBadVertices) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(
      surface_from_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), kLeaf, "m"),
      UnusableInput);
  EXPECT_THROW(
      surface_from_mesh(mesh_of({{0, 0, 0}, {1, 0, nan}, {0, 1, 0}}, {{0, 1, 2}}), kLeaf, "m"),
      UnusableInput);
  EXPECT_THROW(
      surface_from_mesh(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 7}}), kLeaf, "m"),
      UnusableInput);
}

TEST(CloudSurface, FindsNormalsSpacingAndRim) {
  const Surface surface = surface_from_cloud(plane(60, 0.004), {0.001, 0.001, 0.001}, "cloud");
  EXPECT_NEAR(surface.spacing, 0.004, 0.0008);
  for (const Eigen::Vector3d& normal : surface.normals)
    ASSERT_NEAR(std::abs(normal.z()), 1, 1e-9);
  // The rim of a square of 60 x 60 points.
  ASSERT_GE(surface.rim.points.size(), 200U);
  for (std::size_t i = 0; i < surface.rim.points.size(); ++i) {
    const Eigen::Vector3d from_centre = surface.rim.points[i] - Eigen::Vector3d(0.118, 0.118, 0);
    ASSERT_GT(from_centre.cwiseAbs().maxCoeff(), 0.118 - 2 * 0.004);
    ASSERT_GT(from_centre.dot(surface.rim.outward[i]), 0);
  }
}

TEST(CloudSurface, IsThinnedWhereItsPointsAreDenserThanTheirNoise) {
  constexpr std::size_t kMost = 50000;
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> across(0, 0.3);
  std::normal_distribution<double> noise(0, 0.0001);
  Points cloud;
  for (int i = 0; i < 300000; ++i) {
    const double x = across(engine), y = across(engine);
    cloud.emplace_back(x, y, noise(engine));
  }
  const Surface surface = surface_from_cloud(cloud, Eigen::Vector3d::Constant(1e-5), "cloud");
  EXPECT_LE(surface.points.size(), kMost);
  EXPECT_GT(surface.points.size(), kMost / 2);
  double squares = 0;
  for (const Eigen::Vector3d& normal : surface.normals)
    squares += std::pow(std::acos(std::min(1.0, std::abs(normal.z()))), 2);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(surface.normals.size())), 3 * M_PI / 180);
}

TEST(CloudSurface, IsRefusedByNameWhereItCannotBeUsed) {
  const auto complaint = [](const Points& points) -> std::string {
    try {
      surface_from_cloud(points, kLeaf, "object");
    } catch (const UnusableInput& error) {
      return error.what();
    }
    return "";
  };
  Points with_nan = plane(20, 0.002);
  with_nan[7].y() = std::nan("");
  with_nan[8].x() = std::numeric_limits<double>::infinity();
  EXPECT_NE(complaint(with_nan).find("object: 2 of 400 points are not finite"), std::string::npos);
  EXPECT_NE(complaint({}).find("object: no points"), std::string::npos);
  Points line;
  for (int i = 0; i < 500; ++i)
    line.emplace_back(0.001 * i, 0.002 * i, 0);
  EXPECT_NE(complaint(line).find("one line"), std::string::npos);
  EXPECT_NE(complaint(Points(500, Eigen::Vector3d(1, 2, 3))).find("one place"), std::string::npos);
}

TEST(Surfaces, AreMadeOrRefusedWhateverIsInTheFile) {
  for (const auto& target : surface_targets()) {
    SCOPED_TRACE(target.name);
    for (const std::string& seed : target.seeds)
      EXPECT_NO_THROW(target.run(seed)) << seed;
    const std::uint64_t runs = 20000 / target.cost;
    const auto count = scan_cell_common::fuzz(target, 1, runs);
    EXPECT_GT(count.taken, runs / 20);
    EXPECT_GT(count.refused, runs / 4);
  }
}
