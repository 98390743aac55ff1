// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "deviation/scene/path_scene.h"
#include "deviation/scene/reference_scene.h"
#include "drawn_surfaces.h"

using Eigen::Vector3d;
using part_recipes::PathPair;

namespace {

tool_paths::ToolPathFile path_of(const std::vector<Eigen::Isometry3d>& poses) {
  tool_paths::ToolPathFile file;
  file.path.has_orientation = true;
  file.path.segments.push_back({"<i>edge", {}});
  for (const Eigen::Isometry3d& pose : poses)
    file.path.segments[0].waypoints.push_back({pose, {}});
  return file;
}

Eigen::Isometry3d pose_of(const Eigen::Matrix3d& rotation, const Vector3d& at) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation;
  pose.translation() = at;
  return pose;
}

}  // namespace

TEST(PathScene, TellsTheTurnBeyondThatOfThePart) {
  constexpr double kTurn = 0.07;  // [rad]
  const auto part = drawn::moved();
  const Eigen::Matrix3d tool = Eigen::AngleAxisd(0.4, Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(kTurn, Vector3d(1, 2, 2) / 3).toRotationMatrix();
  const PathPair paths{path_of({pose_of(tool, {0.1, 0, 0}), pose_of(tool, {0.2, 0, 0})}),
                       path_of({pose_of(part.rotation * tool, {0.1, 0, 0}),
                                pose_of(tilt * part.rotation * tool, {0.2, 0, 0})})};
  const auto turns = turns_of(paths, part);
  ASSERT_TRUE(turns);
  EXPECT_NEAR((*turns)[0], 0, 1e-7);
  EXPECT_NEAR((*turns)[1], kTurn, 1e-9);
}

TEST(PathScene, OfToolAxesAloneDoesNotCountTheTurnAboutThem) {
  const Eigen::Matrix3d spin = Eigen::AngleAxisd(1, Vector3d::UnitZ()).toRotationMatrix();
  PathPair paths{path_of({pose_of(Eigen::Matrix3d::Identity(), Vector3d::Zero())}),
                 path_of({pose_of(spin, Vector3d::Zero())})};
  EXPECT_NEAR((*turns_of(paths, {}))[0], 1, 1e-9);
  paths.reference.layout.pose.orientation = tool_paths::OrientationKind::kToolVector;
  EXPECT_NEAR((*turns_of(paths, {}))[0], 0, 1e-9);
}

TEST(PathScene, WithoutAPoseOrAnAdaptedPathSaysNothingOfThem) {
  const PathPair paths{path_of({pose_of(Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.3})}), {}};
  const auto all = nlohmann::json::parse(to_json(paths, {}));
  EXPECT_TRUE(all["mapped"].is_null());
  EXPECT_TRUE(all["adapted"].is_null());
  EXPECT_TRUE(all["turns"].is_null());
  EXPECT_EQ(all["segments"][0], "<i>edge");
  EXPECT_EQ(all["reference"][0][2], 0.3);
}

TEST(ReferenceScene, LiesWhereTheSimilarityPutsItAndKnowsWhatWasScanned) {
  const drawn::Folder folder;
  const std::string file = folder.save("plane.ply", drawn::plane());
  drawn::Points half;
  for (const Vector3d& point : drawn::plane(0.0015)) {
    if (point.x() < 0) half.push_back(drawn::moved() * point);
  }
  const auto scene = part_recipes::load_reference_scene(file, 1, drawn::moved(), half, 0.0005);
  ASSERT_GT(scene.points.size(), 500U);
  std::size_t rim = 0;
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Vector3d on_reference = drawn::moved().inverse(scene.points[i]);
    ASSERT_NEAR(on_reference.z(), 0, 1e-7);
    if (scene.rim[i] == 1) {
      ++rim;
      continue;
    }
    constexpr double kBorder = 0.004;  // [m]
    if (std::abs(on_reference.x()) > kBorder) {
      ASSERT_EQ(scene.scanned[i], on_reference.x() < 0);
    }
  }
  EXPECT_GT(rim, 100U);
}

TEST(ReferenceScene, WithoutAPoseStaysAndDoesNotKnowWhatWasScanned) {
  const drawn::Folder folder;
  const auto scene = part_recipes::load_reference_scene(folder.save("plane.ply", drawn::plane()), 1,
                                                        {}, {}, 0.0005);
  ASSERT_FALSE(scene.points.empty());
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    ASSERT_NEAR(scene.points[i].z(), 0, 1e-7);
    ASSERT_TRUE(std::isnan(scene.scanned[i]));
  }
}
