// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report.h"
#include "scan_cell_common/errors/errors.h"
#include "synthetic_parts.h"
#include "verdict/placement_checks.h"

using namespace tool_path_stretcher;
using synthetic::Part;

namespace {

/// A frame with a 180 degree symmetry. Its path is not symmetric: the process values differ.
struct SymmetricFrame {
  Part part = synthetic::photo_frame(0);
  Similarity moved = synthetic::similarity(
      1.1, Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {0.2, -0.1, 0.05});
  StretchParameters parameters;

  ToolPath path() const { return synthetic::path_on(part, 100); }

  Surface surface(const Similarity& similarity, unsigned seed) const {
    synthetic::Scan how;
    how.seed = seed;
    return surface_from_cloud(synthetic::scan(part, similarity, synthetic::no_deformation(), how),
                              parameters.leaf, "frame");
  }

  StretchResult run() const {
    return stretch(surface({}, 11), surface(moved, 1), path(), parameters);
  }

  /// The true path, with the part first turned by 180 degrees or not.
  ToolPath truth(bool turned) const {
    Similarity similarity = moved;
    if (turned) similarity.rotation *= Eigen::Vector3d(-1, -1, 1).asDiagonal();
    return synthetic::truth(path(), similarity, synthetic::no_deformation());
  }

  PosePrior about(bool turned) const {
    PosePrior prior;
    prior.pose.linear() = moved.rotation;
    if (turned) prior.pose.linear() *= Eigen::Vector3d(-1, -1, 1).asDiagonal();
    prior.pose.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 2, 3).normalized()));
    prior.pose.translation() = moved.translation + Eigen::Vector3d(0.01, -0.01, 0.01);
    return prior;
  }
};

double farthest(const Points& waypoints, const ToolPath& truth) {
  double most = 0;
  std::size_t index = 0;
  for (const Segment& segment : truth.segments) {
    for (const Waypoint& waypoint : segment.waypoints)
      most = std::max(most, (waypoints.at(index++) - waypoint.pose.translation()).norm());
  }
  return most;
}

/// The mapping that compresses x to `share` of its length.
Mapping pressed(const Surface& reference, double share) {
  Mapping mapping{{}, DeformationGraph(reference.points, 0.04)};
  for (DeformationGraph::Node& node : mapping.graph.nodes()) {
    node.rotation.setIdentity();
    node.shift = Eigen::Vector3d((share - 1) * node.at.x(), 0, 0);
  }
  return mapping;
}

}  // namespace

TEST(Ambiguous, GivesBothPosesAndWhereTheyPutThePath) {
  const SymmetricFrame frame;
  const StretchResult result = frame.run();
  ASSERT_EQ(to_string(result.verdict.reason), "ambiguous");
  const std::vector<PoseCandidate>& candidates = result.verdict.candidates;
  ASSERT_EQ(candidates.size(), 2U);
  const bool first_turned = farthest(candidates[0].waypoints, frame.truth(true)) < 0.0005;
  EXPECT_LT(farthest(candidates[0].waypoints, frame.truth(first_turned)), 0.0005);
  EXPECT_LT(farthest(candidates[1].waypoints, frame.truth(!first_turned)), 0.0005);
  EXPECT_NEAR(candidates[1].similarity.scale, 1.1, 0.001);
  const auto report = nlohmann::json::parse(report_to_json(result));
  ASSERT_EQ(report["candidates"].size(), 2U);
  EXPECT_EQ(report["candidates"][1]["waypoints"].size(), 100U);
  EXPECT_EQ(report["candidates"][1]["waypoints"][3][0], candidates[1].waypoints[3].x());
}

TEST(OwnImage, OfAPathIsAcceptedAndTheOtherPoseIsNamed) {
  const SymmetricFrame frame;
  ToolPath path = frame.path();
  path.process_names.clear();
  for (Segment& segment : path.segments) {
    for (Waypoint& waypoint : segment.waypoints)
      waypoint.process_values.clear();
  }
  const StretchResult result =
      stretch(frame.surface({}, 11), frame.surface(frame.moved, 1), path, frame.parameters);
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_NE(result.verdict.message.find("another pose"), std::string::npos);
  const std::vector<PoseCandidate>& candidates = result.verdict.candidates;
  ASSERT_EQ(candidates.size(), 2U);
  const bool first_turned = farthest(candidates[0].waypoints, frame.truth(true)) < 0.0005;
  EXPECT_LT(farthest(candidates[0].waypoints, frame.truth(first_turned)), 0.0005);
  EXPECT_LT(farthest(candidates[1].waypoints, frame.truth(!first_turned)), 0.0005);
}

TEST(Prior, OfThePoseDecidesBetweenTheTwo) {
  for (const bool turned : {false, true}) {
    SCOPED_TRACE(turned);
    SymmetricFrame frame;
    frame.parameters.prior.pose = frame.about(turned);
    const StretchResult result = frame.run();
    ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
    EXPECT_LE(synthetic::error_of(result.path, frame.truth(turned)).max, 0.0005);
  }
}

TEST(Prior, OfThePoseThatIsWrongIsNotFollowed) {
  SymmetricFrame frame;
  PosePrior elsewhere = frame.about(false);
  elsewhere.pose.translation().x() += 0.5;
  frame.parameters.prior.pose = elsewhere;
  const StretchResult result = frame.run();
  EXPECT_EQ(to_string(result.verdict.reason), "wrong_part");
  EXPECT_NE(result.verdict.message.find("initial pose"), std::string::npos);
}

TEST(Prior, OfTheScaleThatIsExactIsKept) {
  SymmetricFrame frame;
  frame.part = synthetic::photo_frame();
  frame.parameters.prior.scale = {1.1, 0};
  const StretchResult right = frame.run();
  ASSERT_TRUE(right.verdict.accepted()) << right.verdict.message;
  EXPECT_DOUBLE_EQ(right.similarity.scale, 1.1);
  EXPECT_LE(synthetic::error_of(right.path, frame.truth(false)).max, 0.0003);
  frame.parameters.prior.scale = {0.85, 0};
  EXPECT_FALSE(frame.run().verdict.accepted());
}

TEST(Prior, OfTheScaleWithADeviationLeavesItToTheScan) {
  SymmetricFrame frame;
  frame.part = synthetic::photo_frame();
  frame.parameters.prior.scale = {1.08, 0.01};
  const StretchResult result = frame.run();
  ASSERT_TRUE(result.verdict.accepted()) << result.verdict.message;
  EXPECT_NEAR(result.similarity.scale, 1.1, 0.0005);
}

TEST(Prior, IsRefusedByNameWhereItMakesNoSense) {
  const auto message_of = [](const Prior& prior) -> std::string {
    StretchParameters parameters;
    parameters.prior = prior;
    try {
      check(parameters);
    } catch (const scan_cell_common::InvalidParameter& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message_of({}), "");
  EXPECT_EQ(message_of({{1.0, 0.1}, {}}), "");
  EXPECT_EQ(message_of({{-1, 0}, {}}).find("scale:"), 0U);
  EXPECT_EQ(message_of({{std::nan(""), 0}, {}}).find("scale:"), 0U);
  EXPECT_EQ(message_of({{1, -1}, {}}).find("scale_deviation:"), 0U);
  EXPECT_EQ(message_of({{0, 0.1}, {}}).find("scale_deviation:"), 0U);
  PosePrior pose;
  pose.pose.linear() *= 2;
  EXPECT_EQ(message_of({{}, pose}).find("initial_pose:"), 0U);
  pose = {};
  pose.angle = 0;
  EXPECT_EQ(message_of({{}, pose}).find("initial_pose_angle:"), 0U);
  pose = {};
  pose.distance = -1;
  EXPECT_EQ(message_of({{}, pose}).find("initial_pose_distance:"), 0U);
  EXPECT_THROW(pose_from_numbers({0, 0, 0, 1}), scan_cell_common::InvalidParameter);
  EXPECT_THROW(pose_from_numbers({0, 0, 0, 0, 0, 0, 0}), scan_cell_common::InvalidParameter);
}

TEST(FoldOver, IsRefusedWhereTheSurfaceIsTurnedOver) {
  const SymmetricFrame frame;
  const Surface reference = frame.surface({}, 11);
  const auto checked = [&](double share) {
    const Mapping mapping = pressed(reference, share);
    ToolPath adapted = frame.path();
    for (Segment& segment : adapted.segments) {
      for (Waypoint& waypoint : segment.waypoints)
        waypoint.pose.translation() = mapping * waypoint.pose.translation();
    }
    try {
      check_fold_over(frame.path(), adapted, {reference, reference}, mapping);
    } catch (const Refusal& refusal) {
      return refusal.verdict;
    }
    return Verdict{};
  };
  EXPECT_EQ(to_string(checked(0.9).reason), "accepted");
  EXPECT_EQ(to_string(checked(-0.5).reason), "fold_over");
  EXPECT_FALSE(checked(-0.5).waypoints.empty());
}

TEST(FoldOver, IsRefusedWhereThePathRunsBack) {
  const SymmetricFrame frame;
  const Surface reference = frame.surface({}, 11);
  ToolPath adapted = frame.path();
  std::vector<Waypoint>& waypoints = adapted.segments[0].waypoints;
  std::swap(waypoints[10].pose, waypoints[11].pose);
  try {
    check_fold_over(frame.path(), adapted, {reference, reference}, {});
    FAIL() << "not refused";
  } catch (const Refusal& refusal) {
    EXPECT_EQ(to_string(refusal.verdict.reason), "fold_over");
    EXPECT_EQ(refusal.verdict.waypoints, std::vector<std::size_t>{11});
  }
}
