// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/io/ply_io.h>
#include <unistd.h>

#include <filesystem>

#include "cloud_preprocess/clean.h"
#include "parts_finder.h"
#include "scan_cell_common/errors/errors.h"
#include "scanner_views/blocks.h"
#include "scanner_views/parts/part_list.h"
#include "scanner_views/scanner/looking.h"
#include "scanner_views/scanner/surroundings.h"

using namespace scanner_views;
using Eigen::Vector3d;

namespace {

Mesh casing_mesh() {
  constexpr std::size_t kCasing = 2;
  Draws draws(1);
  return plate_parts(draws)[kCasing].mesh;
}

/// The mesh rotated about the vertical and moved.
Mesh lying(const Mesh& mesh, double turn, double x, double y) {
  return moved(mesh, [&](const Vector3d& at) -> Vector3d {
    return Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * at + Vector3d(x, y, 0);
  });
}

/// A line scan of surfaces, with the surface of each point.
class Table {
 public:
  /// @param meshes the scanned part first
  explicit Table(const std::vector<Mesh>& meshes, Viewing viewing = Viewing::kAboveBothLasers) {
    constexpr double kAround = 0.3;  // [m]
    Draws draws(5);
    points_ = scan(meshes, {viewing, kAround}, draws);
  }

  /// Removes the points between two x [m].
  void darken(double from, double to) {
    ScanPoints lit;
    for (std::size_t i = 0; i < points_.places.size(); ++i) {
      if (points_.places[i].x() > from && points_.places[i].x() < to) continue;
      lit.places.push_back(points_.places[i]);
      lit.surfaces.push_back(points_.surfaces[i]);
    }
    points_ = lit;
  }

  cloud_preprocess::Cloud cloud() const { return tool_path_stretcher::to_cloud(points_.places); }

  /// The remaining share of these surfaces' points.
  double share(const cloud_preprocess::TracedCloud& left, const std::vector<unsigned>& of) const {
    const auto is_of = [&](unsigned surface) {
      return std::find(of.begin(), of.end(), surface) != of.end();
    };
    double found = 0;
    for (const std::uint32_t source : left.sources())
      found += is_of(points_.surfaces[source]) ? 1 : 0;
    return found / static_cast<double>(
                       std::count_if(points_.surfaces.begin(), points_.surfaces.end(), is_of));
  }

  Vector3d middle(unsigned surface) const {
    Vector3d sum = Vector3d::Zero();
    double count = 0;
    for (std::size_t i = 0; i < points_.places.size(); ++i) {
      if (points_.surfaces[i] != surface) continue;
      sum += points_.places[i];
      count += 1;
    }
    return sum / count;
  }

 private:
  ScanPoints points_;
};

class CleanByReference : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Cleans the scan; outliers stay, so that all of the part stays.
  /// @param reference empty: keeps the largest object
  cloud_preprocess::TracedCloud cleaned(const Table& table, const Mesh& reference,
                                        bool across_shadows = true) {
    cloud_preprocess::CleanParameters parameters;
    parameters.outliers.automatic = false;
    parameters.grid.reset();
    parameters.isolate.across_shadows = across_shadows;
    if (!reference.vertices.empty()) select(reference, parameters.isolate);
    cloud_preprocess::TracedCloud cloud(table.cloud());
    std::vector<cloud_preprocess::StageReport> reports;
    cloud_preprocess::clean(cloud, parameters, reports);
    said_ = reports.back().message;
    return cloud;
  }

  std::string refusal(const Table& table, const Mesh& reference) {
    try {
      cleaned(table, reference);
    } catch (const scan_cell_common::UnusableInput& error) {
      return error.what();
    }
    return "not refused: " + said_;
  }

  bool as_mesh_ = false;  // reference as a mesh; false: as a scan, which is faster
  std::string said_;

 private:
  void select(const Mesh& reference, cloud_preprocess::IsolationParameters& isolate) const {
    isolate.select = cloud_preprocess::Selection::kReference;
    isolate.reference = (folder_ / "reference.ply").string();
    if (as_mesh_) {
      pcl::io::savePLYFileBinary(isolate.reference, to_polygon_mesh(reference));
    } else {
      Draws draws(9);
      scan_cell_common::save_cloud(
          isolate.reference,
          tool_path_stretcher::to_cloud(scan({reference}, {Viewing::kTwoSides}, draws).places));
    }
    const auto finder = std::make_shared<tool_path_stretcher::PartsFinder>();
    finder->load(isolate.reference, 1);
    isolate.finder = finder;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("clean_by_reference_" + std::to_string(getpid()));
};

Mesh floor_below() {
  return moved(block(1.2, 1.2, 0.01),
               [](const Vector3d& at) -> Vector3d { return at - Vector3d(0, 0, 0.01); });
}

/// The foot of a part near the floor is removed with it.
constexpr double kWhole = 0.97;

void expect_place(const std::string& said, const Vector3d& place) {
  constexpr double kNear = 0.01;  // [m]
  double nearest = 1;
  for (std::size_t at = said.find("about ("); at != std::string::npos;
       at = said.find("about (", at + 1)) {
    double x = 0, y = 0, z = 0;
    ASSERT_EQ(std::sscanf(said.c_str() + at, "about (%lf, %lf, %lf)", &x, &y, &z), 3) << said;
    nearest = std::min(nearest, (Vector3d(x, y, z) - place).norm());
  }
  EXPECT_LT(nearest, kNear) << place.transpose() << " not in: " << said;
}

}  // namespace

TEST_F(CleanByReference, TwoOfAKindAreRefusedWithBothPlaces) {
  as_mesh_ = true;
  const Mesh casing = casing_mesh();
  const Table table({lying(casing, 0.7, 0, 0), floor_below(), lying(casing, -0.4, 0.3, 0.05)});
  const std::string said = refusal(table, casing);
  EXPECT_NE(said.find("explains 2 objects"), std::string::npos) << said;
  expect_place(said, table.middle(0));
  expect_place(said, table.middle(2));
}

TEST_F(CleanByReference, WhatAShadowToreOffStays) {
  const Mesh casing = casing_mesh();
  Table table({lying(casing, 0, 0, 0), floor_below()});
  table.darken(0.03, 0.045);       // wider than the gap between objects
  constexpr bool kJoined = false;  // across shadows, by the isolation itself
  EXPECT_LT(table.share(cleaned(table, {}, kJoined), {0}), 0.8) << "nothing is torn off";
  const auto left = cleaned(table, casing, kJoined);
  EXPECT_GT(table.share(left, {0}), kWhole) << said_;
  EXPECT_LT(table.share(left, {1}), 0.001);
}

TEST_F(CleanByReference, OfClampsOnlyWhatStandsOverThePartStays) {
  const Mesh casing = casing_mesh();
  Draws draws(3);
  std::vector<Mesh> meshes = {lying(casing, 0, 0, 0), floor_below()};
  Surroundings surroundings;
  surroundings.clamps = true;
  for (Mesh& clamp : meshes_of(surroundings, meshes.front(), casing, draws))
    meshes.push_back(std::move(clamp));
  ASSERT_EQ(meshes.size(), 6U);  // a finger and a post each
  const Table table(meshes);
  const auto left = cleaned(table, casing);
  EXPECT_GT(table.share(left, {0}), kWhole) << said_;
  EXPECT_GT(table.share(left, {2, 4}), 0.05) << "fingers, half over the part";
  EXPECT_LT(table.share(left, {2, 4}), 0.8);
  EXPECT_LT(table.share(left, {3, 5}), 0.02) << "posts, 12 mm beside it";
}
