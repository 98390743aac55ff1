// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "frame/scripted_camera.h"

using namespace scripted;  // NOLINT

TEST_F(AcquisitionOfScriptedCamera, DeliversNothingUntilItIsStarted) {
  Acquisition& acquisition = start();
  script_.send(1);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kStop);
  EXPECT_TRUE(recorder_.frames().empty());
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal), 1U);
  expect_frames({{1, 1, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, GivesEachStartANumber) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal), 1U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::kStop, Trigger::kExternal), 0U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kExternal), 2U);
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefLive, Trigger::kExternal), 3U);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kReliefLive);
}

TEST_F(AcquisitionOfScriptedCamera, AnswersAStartInFreeRunOnlyWithTheFirstFrame) {
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun), ConnectionError);
  script_.send(77);
  EXPECT_GT(acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun), 0U);
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
    acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun);
    ADD_FAILURE() << "a camera that sends peaks alone has no live images";
  } catch (const scan_cell_common::UnusableInput& error) {
    EXPECT_NE(std::string(error.what()).find("no image"), std::string::npos) << error.what();
  }
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kStop);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_TRUE(recorder_.frames().empty());
  script_.send(relief);
  EXPECT_GT(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kFreeRun), 0U);
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhereARecordingEndsAndSaysSo) {
  Acquisition& acquisition = start();
  script_.send(1);
  script_.end();
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal), 1U);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::kStop; }));
  expect_frames({{1, 1, 0}});
  EXPECT_NE(acquisition.state().message.find("ended"), std::string::npos);
  EXPECT_EQ(recorder_.endings, 1);
  EXPECT_TRUE(recorder_.troubles().empty()) << "that is no trouble";
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  lose_and_find();
  acquisition.set(AcquisitionMode::kStop, Trigger::kExternal);
  EXPECT_EQ(acquisition.state().acquisition, 1U) << "what has ended is not resumed";
  script_.send(1);  // but can be played again
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kFreeRun), 2U);
}

TEST_F(AcquisitionOfScriptedCamera, ResumesAnExternalTriggerWithANewNumberAfterALoss) {
  Acquisition& acquisition = start();
  EXPECT_EQ(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal), 1U);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::kReliefOnly; }));
  script_.send(9);
  expect_frames({{2, 9, 0}});
  EXPECT_EQ(acquisition.state().times_lost, 1U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StaysStoppedAfterALossInFreeRun) {
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun);
  lose_and_find();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kStop);
  EXPECT_NE(acquisition.state().message, "");
  script_.send(2);
  EXPECT_EQ(acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun), 2U);
  EXPECT_EQ(acquisition.state().message, "");
}

TEST_F(AcquisitionOfScriptedCamera, StopsWhatWasToBeResumedAlsoWhileTheCameraIsAway) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.plug(false);
  EXPECT_TRUE(wait_until([&] { return !acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::kStop, Trigger::kExternal), 0U);
  script_.plug(true);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().connected; }));
  EXPECT_EQ(acquisition.set(AcquisitionMode::kStop, Trigger::kExternal), 0U);
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, LosesACameraThatFallsSilentInFreeRun) {
  parameters_.silence_timeout = 0.1;
  Acquisition& acquisition = start();
  script_.send(1);
  acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kFreeRun);
  EXPECT_TRUE(wait_until([&] { return acquisition.state().times_lost == 1; }));
}

TEST_F(AcquisitionOfScriptedCamera, SaysAReasonOnceHoweverOftenItTries) {
  script_.plugged_in = false;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::kLiveOnly, Trigger::kExternal), ConnectionError);
  EXPECT_EQ(recorder_.troubles().size(), 1U);
  EXPECT_EQ(acquisition.state().times_lost, 0U);
  EXPECT_NE(acquisition.state().message.find("unplugged"), std::string::npos);
}

TEST_F(AcquisitionOfScriptedCamera, StartsByItselfOnlyIfToldTo) {
  parameters_.mode = AcquisitionMode::kReliefOnly;
  Acquisition& acquisition = start();
  EXPECT_TRUE(wait_until([&] { return acquisition.state().mode == AcquisitionMode::kReliefOnly; }));
  EXPECT_EQ(acquisition.state().acquisition, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, StaysConnectedWhereAStartIsRefused) {
  script_.refuse_start = true;
  Acquisition& acquisition = start();
  EXPECT_THROW(acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal),
               tecnogamma_camera::MissingFeature);
  EXPECT_TRUE(acquisition.state().connected);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kStop);
}

TEST_F(AcquisitionOfScriptedCamera, WritesSettingsBetweenStopAndStartAllOrNone) {
  using Change = tecnogamma_camera::CameraChange;
  const Change good{0.002, {0, 0, 64, 64}}, too_long{2, {0, 0, 32, 32}}, own{0, {0, 0, 64, 64}};
  Acquisition& acquisition = start();
  const auto set = [&](AcquisitionMode mode, const Change& change) {
    return acquisition.set(mode, Trigger::kExternal, change);
  };
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  set(AcquisitionMode::kReliefOnly, good);
  EXPECT_EQ(script_.exposure, 0.002);
  EXPECT_EQ(script_.region.width, 64);
  EXPECT_EQ(acquisition.state().settings.region.width, 64);
  EXPECT_THROW(set(AcquisitionMode::kReliefOnly, too_long), scan_cell_common::InvalidParameter);
  EXPECT_EQ(acquisition.state().mode, AcquisitionMode::kStop);
  EXPECT_EQ(script_.exposure, 0.002);
  EXPECT_EQ(script_.region.width, 64);
  EXPECT_THROW(set(AcquisitionMode::kStop, own), scan_cell_common::Refused);
}

TEST_F(AcquisitionOfScriptedCamera, LeavesGainAndRateAsTheyAreWhereTheyAreNotGiven) {
  Acquisition& acquisition = start();
  tecnogamma_camera::CameraChange change{0.002, {0, 0, 64, 64}};
  int taken = 0;
  change.on_taken = [&] { ++taken; };
  change.gain = 3;
  change.rate = 40;
  acquisition.set(AcquisitionMode::kStop, Trigger::kExternal, change);
  change.gain = change.rate = std::nullopt;
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal, change);
  EXPECT_EQ(acquisition.state().settings.gain, 3);
  EXPECT_EQ(acquisition.state().settings.rate, 40);
  EXPECT_EQ(taken, 2);
  change.exposure = 2;
  EXPECT_THROW(acquisition.set(AcquisitionMode::kStop, Trigger::kExternal, change),
               scan_cell_common::InvalidParameter);
  EXPECT_EQ(taken, 2) << "what the camera refuses is not taken";
}

TEST_F(AcquisitionOfScriptedCamera, ChangesTheRegionOnlyInStopAndTheExposureAlways) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  EXPECT_THROW(acquisition.set_region({0, 0, 64, 64}), scan_cell_common::Refused);
  acquisition.set_exposure(0.002);
  EXPECT_EQ(script_.exposure, 0.002);
  EXPECT_THROW(acquisition.set_exposure(2), scan_cell_common::InvalidParameter);
  acquisition.set(AcquisitionMode::kStop, Trigger::kExternal);
  acquisition.set_region({0, 0, 64, 64});
  lose_and_find();
  acquisition.set(AcquisitionMode::kStop, Trigger::kExternal);
  EXPECT_EQ(script_.exposure, 0.002);  // both hold for the camera that is found again
  EXPECT_EQ(script_.region.width, 64);
}
