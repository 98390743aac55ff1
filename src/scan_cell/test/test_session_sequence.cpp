// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "session_cell.h"

using session_test::SessionSequence;

TEST_F(SessionSequence, TakesTheBoardInTheDarkAndEachLaserAloneAtEachPose) {
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kFinished) << result.end.message;
  EXPECT_EQ(result.views, 4);
  EXPECT_TRUE(result.skipped.empty());
  ASSERT_EQ(observer_.views.size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const scan_cell::TakenView& view = observer_.views[i];
    EXPECT_EQ(view.base_to_flange.translation(), Eigen::Vector3d(i + 1, 0, 1e-5))
        << "the measured pose, not the taught one";
    EXPECT_EQ(view.board.image.at<std::uint8_t>(0), 0);
    ASSERT_EQ(view.lines.size(), 2U);
    EXPECT_EQ(view.lines[0].image.at<std::uint8_t>(0), 1);
    EXPECT_EQ(view.lines[1].image.at<std::uint8_t>(0), 2);
  }
  EXPECT_EQ(camera_.exposures.size(), 12U);
  EXPECT_EQ(camera_.exposures[0], 0.2);
  EXPECT_EQ(camera_.exposures[1], 0.001);
  EXPECT_LT(trigger_.rates[0], 1 / 0.2) << "pulses must not come before the exposure is over";
  expect_safe();
}

TEST_F(SessionSequence, TakesOnlyTheLasersAskedFor) {
  request_.lasers = 2;
  EXPECT_EQ(run().views, 4);
  EXPECT_EQ(cell_.count("arm 1"), 0);
  EXPECT_EQ(observer_.views[0].lines.size(), 1U);
}

TEST_F(SessionSequence, TakesTheBoardAloneWithoutALaser) {
  request_.lasers = 0;
  EXPECT_EQ(run().views, 4);
  EXPECT_EQ(cell_.count("arm 1") + cell_.count("arm 2"), 0);
  EXPECT_TRUE(observer_.views[0].lines.empty());
  EXPECT_EQ(camera_.exposures.size(), 4U);
  expect_safe();
}

TEST_F(SessionSequence, SkipsAndNamesAPoseThatTheRobotRefuses) {
  robot_.ends[2] = {Motion::State::kFailed, 0, "out of reach"};
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kFinished);
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_EQ(result.skipped[0].name, "line 3");
  EXPECT_EQ(result.skipped[0].reason, "out of reach");
  expect_safe();
}

TEST_F(SessionSequence, SkipsAPoseWhereTheRobotDoesNotComeToRest) {
  robot_.restless_at = 1;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_EQ(result.skipped[0].name, "line 2");
  EXPECT_NE(result.skipped[0].reason.find("rest"), std::string::npos);
}

TEST_F(SessionSequence, SkipsAPoseWhereTheRobotMovedWhileImagesWereTaken) {
  robot_.slips_at = 1;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_NE(result.skipped[0].reason.find("moved while"), std::string::npos);
}

TEST_F(SessionSequence, SkipsAPoseWithoutAnImageAndGoesOn) {
  camera_.blind_from = camera_.blind_to = 2;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kFinished);
  EXPECT_EQ(result.views, 3);
  ASSERT_EQ(result.skipped.size(), 1U);
  EXPECT_NE(result.skipped[0].reason.find("no image of the board"), std::string::npos);
  expect_safe();
}

TEST_F(SessionSequence, EndsAsCameraLostWhereSeveralPosesInARowGiveNoImage) {
  camera_.blind_from = 2;
  timing_.max_blind_poses = 2;
  const scan_cell::SessionEnd result = run();
  EXPECT_EQ(result.end.outcome, Outcome::kCameraLost);
  EXPECT_EQ(result.views, 1) << "what was recorded is kept";
  EXPECT_EQ(result.skipped.size(), 2U);
  EXPECT_EQ(cell_.count("move 4"), 0);
  expect_safe();
}
