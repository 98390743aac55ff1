// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "frame/scripted_camera.h"

using namespace scripted;  // NOLINT

TEST_F(AcquisitionOfScriptedCamera, DeliversNothingUntilItIsStarted) {
  Acquisition& acquisition = start();
  script_.send(1);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_TRUE(recorder_.frames().empty());
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  expect_frames({{1, 1, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, GivesEachStartANumber) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::EXTERNAL), 2U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_LIVE, Trigger::EXTERNAL), 3U);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::RELIEF_LIVE);
}

TEST_F(AcquisitionOfScriptedCamera, AnswersAStartInFreeRunOnlyWithTheFirstFrame) {
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), ConnectionError);
  script_.send(77);
  EXPECT_GT(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), 0U);
  EXPECT_EQ(recorder_.frames().back().counter, 77U);
}

TEST_F(AcquisitionOfScriptedCamera, RefusesAStartInFreeRunWhereNoFrameCanBeUsed) {
  parameters_.start_timeout = 0.2;
  Acquisition& acquisition = start();
  tecnogamma_camera::PeakProfile peaks;
  Frame relief;
  relief.counter = 1;
  relief.peaks = &peaks;
  script_.send(relief);
  try {
    acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
    ADD_FAILURE() << "a camera that sends peaks alone has no live images";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("no image"), std::string::npos) << error.what();
  }
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_TRUE(recorder_.frames().empty());
  script_.send(relief);
  EXPECT_GT(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::FREE_RUN), 0U);
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhereARecordingEndsAndSaysSo) {
  Acquisition& acquisition = start();
  script_.send(1);
  script_.end();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::STOP; }));
  expect_frames({{1, 1, 0}});
  EXPECT_NE(acquisition.state().message.find("ended"), std::string::npos);
  EXPECT_EQ(recorder_.endings, 1);
  EXPECT_TRUE(recorder_.troubles().empty()) << "that is no trouble";
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  lose_and_find();
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  EXPECT_EQ(acquisition.state().acquisition, 1U) << "what has ended is not resumed";
  script_.send(1);  // but can be played again
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::FREE_RUN), 2U);
}

TEST_F(AcquisitionOfScriptedCamera, ResumesAnExternalTriggerWithANewNumberAfterALoss) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL), 1U);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::RELIEF_ONLY; }));
  script_.send(9);
  expect_frames({{2, 9, 0}});
  EXPECT_EQ(acquisition.state().times_lost, 1U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StaysStoppedAfterALossInFreeRun) {
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
  EXPECT_NE(acquisition.state().message, "");
  script_.send(2);
  EXPECT_EQ(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN), 2U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhatWasToBeResumedAlsoWhileTheCameraIsAway) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  script_.plug(false);
  EXPECT_TRUE(wait_until([&] { return !acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  script_.plug(true);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL), 0U);
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, LosesACameraThatFallsSilentInFreeRun) {
  parameters_.silence_timeout = 0.1;
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::FREE_RUN);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().times_lost == 1; }));
}

TEST_F(AcquisitionOfScriptedCamera, SaysAReasonOnceHoweverOftenItTries) {
  script_.plugged_in = false;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::LIVE_ONLY, Trigger::EXTERNAL), ConnectionError);
  EXPECT_EQ(recorder_.troubles().size(), 1U);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  EXPECT_NE(acquisition.state().message.find("unplugged"), std::string::npos);
}

TEST_F(AcquisitionOfScriptedCamera, StartsByItselfOnlyIfToldTo) {
  parameters_.mode = AcquisitionMode::RELIEF_ONLY;
  Acquisition& acquisition = start();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::RELIEF_ONLY; }));
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, StaysConnectedWhereAStartIsRefused) {
  script_.refuse_start = true;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL),
               tecnogamma_camera::MissingFeature);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::STOP);
}

TEST_F(AcquisitionOfScriptedCamera, ChangesTheRegionOnlyInStopAndTheExposureAlways) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::RELIEF_ONLY, Trigger::EXTERNAL);
  EXPECT_THROW(acquisition.set_region({0, 0, 64, 64}), scan_cell_common::Refused);
  acquisition.set_exposure(0.002);
  EXPECT_EQ(script_.exposure, 0.002);
  EXPECT_THROW(acquisition.set_exposure(2), scan_cell_common::InvalidParameter);
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  acquisition.set_region({0, 0, 64, 64});
  lose_and_find();
  acquisition.set(AcquisitionMode::STOP, Trigger::EXTERNAL);
  EXPECT_EQ(script_.exposure, 0.002);  // both hold for the camera that is found again
  EXPECT_EQ(script_.region.width, 64);
}
