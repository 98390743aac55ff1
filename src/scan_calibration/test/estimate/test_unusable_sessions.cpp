// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "estimate/synthetic_session.h"
#include "scan_calibration/calibration.h"
#include "scan_cell_common/errors/errors.h"

using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_calibration::calibrate;
using scan_calibration::Observations;
using scan_calibration::ViewObservation;

namespace {

constexpr double kDegree = M_PI / 180;
const synthetic::Noise kLightNoise = {0.1, 0.1, 1e-4, 1e-4};

Observations session(const synthetic::Poses& poses, const synthetic::Cell& cell = {}) {
  return observe(cell, flange_poses(cell, poses), kLightNoise, 1);
}

Observations good() {
  synthetic::Poses poses;
  poses.count = 20;
  return session(poses);
}

/// "THING: VALUE; CURE" of the refusal.
std::string refused(const Observations& observations) {
  try {
    calibrate(observations, {});
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "nothing";
}

/// Observations with the poses of all views replaced.
Observations with_poses(const std::function<Isometry3d(const Isometry3d&)>& change) {
  Observations observations = good();
  for (ViewObservation& view : observations.views)
    view.base_to_flange = change(view.base_to_flange);
  return observations;
}

}  // namespace

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(UnusableSession, OfTooFewViewsSaysHowManyAreNeeded) {
  Observations observations = good();
  observations.views.resize(5);
  EXPECT_SAYS(refused(observations), "views of the session: 5 usable; 6 at different poses");
}

TEST(UnusableSession, WithoutTheBoardSaysWhatTheViewsLack) {
  Observations observations = good();
  for (ViewObservation& view : observations.views)
    view.corners.clear();
  EXPECT_SAYS(refused(observations), "0 usable, view0 shows 0 corners of the board");
}

TEST(UnusableSession, OfParallelViewsSaysWhatIsUndetermined) {
  synthetic::Poses poses;
  poses.count = 20;
  poses.max_tilt = 0;
  EXPECT_SAYS(refused(session(poses)), "all parallel: the board's tilt to the camera differs by");
}

TEST(UnusableSession, OfTurnsAboutOneAxisSaysWhatIsUndetermined) {
  const synthetic::Cell cell;
  const Isometry3d first = flange_poses(cell, {})[0];
  std::vector<Isometry3d> poses;
  const Vector3d middle = cell.base_to_board * Vector3d(0.24, 0.14, 0);
  for (int i = 0; i < 20; ++i) {
    Isometry3d turn = Isometry3d::Identity();
    turn.linear() = Eigen::AngleAxisd((i - 10) * 3 * kDegree, Vector3d(1, 0, 0)).toRotationMatrix();
    turn.translation() = middle - turn.linear() * middle;
    turn.pretranslate(Vector3d(0.003 * (i % 3), 0.004 * (i % 5), 0.01 * (i % 4)));
    poses.push_back(turn * first);
  }
  const std::string text = refused(observe(cell, poses, kLightNoise, 1));
  EXPECT_SAYS(text, "orientations of the flange: about one axis only");
  EXPECT_SAYS(text, "the camera's position on the flange along this axis is undetermined");
}

TEST(UnusableSession, WithTheWrongBoardSizeSaysTheOneThatFits) {
  Observations observations = good();
  observations.board.square_size = 0.025;
  const std::string text = refused(observations);
  EXPECT_SAYS(text, "board square size: 25 mm; the robot's travel says 20 mm");
}

TEST(UnusableSession, WithTheBoardInMillimetresSaysTheSizeThatFits) {
  Observations observations = good();
  observations.board.square_size = 20;
  EXPECT_SAYS(refused(observations), "the robot's travel says 20 mm");
}

TEST(UnusableSession, WithPosesInMillimetresSaysSo) {
  const std::string text = refused(with_poses([](Isometry3d pose) {
    pose.translation() *= 1000;
    return pose;
  }));
  EXPECT_SAYS(text, "positions of the poses: the flange travels");
  EXPECT_SAYS(text, "they are in millimetres");
}

TEST(UnusableSession, OutOfStepByOneSaysWhichWay) {
  for (const int shift : {1, -1}) {
    Observations observations = good();
    const Observations original = observations;
    const int count = static_cast<int>(original.views.size());
    for (int i = 0; i < count; ++i) {
      const auto from = static_cast<std::size_t>(std::clamp(i + shift, 0, count - 1));
      observations.views[static_cast<std::size_t>(i)].base_to_flange =
          original.views[from].base_to_flange;
    }
    // The image of view i was recorded with the pose of its neighbour on one side, so it goes with
    // the neighbour on the other side.
    EXPECT_SAYS(refused(observations), shift > 0 ? "go with the pose of the view before it"
                                                 : "go with the pose of the view after it");
  }
}

TEST(UnusableSession, OutOfStepFromAViewOnSaysFromWhich) {
  Observations observations = good();
  const Observations original = observations;
  for (std::size_t i = 13; i + 1 < original.views.size(); ++i)
    observations.views[i].base_to_flange = original.views[i + 1].base_to_flange;
  observations.views.pop_back();
  EXPECT_SAYS(refused(observations), "out of step with the images: from view14 on");
}

TEST(UnusableSession, WithRadiansReadAsDegreesSaysSo) {
  const std::string text = refused(with_poses([](Isometry3d pose) {
    const Eigen::AngleAxisd turn(pose.linear());
    pose.linear() = Eigen::AngleAxisd(turn.angle() * kDegree, turn.axis()).toRotationMatrix();
    return pose;
  }));
  EXPECT_SAYS(text, "they are in radians and were read as degrees");
}

TEST(UnusableSession, WithDegreesReadAsRadiansSaysSo) {
  const std::string text = refused(with_poses([](Isometry3d pose) {
    const Vector3d angles = pose.linear().eulerAngles(2, 1, 2) / kDegree;
    pose.linear() = (Eigen::AngleAxisd(angles[0], Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(angles[1], Vector3d::UnitY()) *
                     Eigen::AngleAxisd(angles[2], Vector3d::UnitZ()))
                        .toRotationMatrix();
    return pose;
  }));
  EXPECT_SAYS(text, "angles of the poses: the flange's positions fit the images");
  EXPECT_SAYS(text, "degrees were read as radians");
}

TEST(UnusableSession, WithPosesTheWrongWayRoundSaysSo) {
  EXPECT_SAYS(refused(with_poses([](const Isometry3d& pose) { return pose.inverse(); })),
              "20 of 20 fit the images when inverted");
}

TEST(UnusableSession, OfARepeatedPoseNamesIt) {
  Observations observations = good();
  for (std::size_t i = 5; i < observations.views.size(); ++i)
    observations.views[i] = observations.views[i % 5];
  for (std::size_t i = 0; i < observations.views.size(); ++i)
    observations.views[i].name = "view" + std::to_string(i);
  EXPECT_SAYS(refused(observations), "5 usable, view5 repeats the pose of view0");
}

TEST(UnusableSession, WhosePoseWasRecordedOnceNamesTheViews) {
  Observations observations = good();
  for (ViewObservation& view : observations.views)
    view.base_to_flange = observations.views[0].base_to_flange;
  EXPECT_SAYS(refused(observations), "only 1 different in 20 views: view1 has the pose of view0");
}

TEST(UnusableSession, OfALaserThatNeverShowsNamesIt) {
  Observations observations = good();
  for (ViewObservation& view : observations.views)
    view.lines[1].clear();
  EXPECT_SAYS(refused(observations), "laser_1: its line shows in 0 of 20 views; check that it is");
}

TEST(UnusableSession, OfALaserOnOneLineSaysHowFarItSpreads) {
  // The line is shown only in views with the board at the same pose to the camera; the other views
  // lack it.
  Observations observations = good();
  const synthetic::Cell cell;
  synthetic::Poses poses;
  poses.count = 4;
  poses.max_tilt = 0;
  poses.nearest = poses.farthest = 0.5;
  poses.seed = 9;
  for (ViewObservation& view : observations.views)
    view.lines[0].clear();
  for (ViewObservation view : observe(cell, flange_poses(cell, poses), kLightNoise, 2).views) {
    view.name = "flat " + view.name;
    observations.views.push_back(view);
  }
  const std::string text = refused(observations);
  EXPECT_SAYS(text, "laser_0: its points lie along one line");
}

TEST(UnusableSession, OfAnotherBoardIsRefused) {
  Observations observations = good();
  for (ViewObservation& view : observations.views)
    for (scan_calibration::SeenCorner& corner : view.corners)
      std::swap(corner.column, corner.row);
  observations.board.columns = observations.board.rows = 25;
  for (ViewObservation& view : observations.views)
    for (scan_calibration::SeenCorner& corner : view.corners)
      corner.row = (corner.row * 7) % 25;
  EXPECT_SAYS(refused(observations), "corners of the board: ");
}

TEST(UnusableSession, OfNonsenseIsRefusedByName) {
  Observations observations = good();
  observations.views[3].corners[7].column = 25;
  EXPECT_SAYS(refused(observations), "view view3: corner 25, ");
  observations = good();
  observations.views[2].base_to_flange.translation().x() = NAN;
  EXPECT_SAYS(refused(observations), "view view2: its pose is not finite");
  observations = good();
  observations.board.square_size = 0;
  EXPECT_SAYS(refused(observations), "board square size");
}
