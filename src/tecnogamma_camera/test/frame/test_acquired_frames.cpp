// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "frame/scripted_camera.h"

using namespace scripted;  // NOLINT

TEST_F(AcquisitionOfScriptedCamera, UnwrapsTheCounterAndCountsWhatIsMissing) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  for (const std::uint64_t raw : {65534, 65535, 0, 3, 3})
    script_.send(raw);
  script_.send(70000);
  script_.send(4);
  expect_frames(
      {{1, 65534, 0}, {1, 65535, 0}, {1, 65536, 0}, {1, 65539, 0}, {1, 65539, 0}, {1, 65540, 0}});
  const auto frames = acquisition.state().frames;
  EXPECT_EQ(frames.received, 7U);
  EXPECT_EQ(frames.lost, 2U);
  EXPECT_EQ(frames.repeated, 1U);
  EXPECT_EQ(frames.invalid, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TellsALateFrameFromARestartedCamera) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.send(50, 5000);
  script_.send(49, 4900);  // late: its time is earlier
  script_.send(51, 5100);
  script_.send(1, 5200);  // restarted: its time goes on, and the next frame counts on from it
  script_.send(2, 5300);
  script_.send(3, 5400);
  expect_frames({{1, 50, 0}, {1, 49, 0}, {1, 51, 0}, {1, 1, 0}, {2, 2, 0}, {2, 3, 0}});
  EXPECT_EQ(acquisition.state().frames.late, 2U);
  EXPECT_EQ(acquisition.state().frames.restarts, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesACounterWithoutClockThatCountsOnFromLessForRestarted) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  for (const std::uint64_t raw : {50, 49, 51, 48, 52, 1, 2, 3, 4})
    script_.send(raw);
  // 49 and 48 are late; 1 and 2 could be late, too, and only 3 shows that the camera was restarted.
  expect_frames({{1, 50, 0},
                 {1, 49, 0},
                 {1, 51, 0},
                 {1, 48, 0},
                 {1, 52, 0},
                 {1, 1, 0},
                 {1, 2, 0},
                 {2, 3, 0},
                 {2, 4, 0}});
  EXPECT_EQ(acquisition.state().frames.late, 4U);
  EXPECT_EQ(acquisition.state().frames.restarts, 1U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesLateFramesBetweenOthersForLateHoweverMany) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  for (const std::uint64_t raw : {50, 40, 51, 41, 52, 42, 53})
    script_.send(raw);
  expect_frames(
      {{1, 50, 0}, {1, 40, 0}, {1, 51, 0}, {1, 41, 0}, {1, 52, 0}, {1, 42, 0}, {1, 53, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, NoticesARestartAlsoWhereTheClockWasSetBackWithTheCounter) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.send(500, 5000000);
  for (std::uint64_t raw = 1; raw <= 4; ++raw)
    script_.send(raw, static_cast<scan_cell_common::Nanoseconds>(1000 * raw));
  expect_frames({{1, 500, 0}, {1, 1, 0}, {1, 2, 0}, {2, 3, 0}, {2, 4, 0}});
}

TEST_F(AcquisitionOfScriptedCamera, BeginsANewAcquisitionWhereTheFrameSaysSo) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  Frame frame;
  frame.counter = 7;
  frame.device_time = 700;
  script_.send(frame);
  frame.restarted = true;
  script_.send(frame);
  frame.fault = "damaged";  // it may be the first of a turn that is
  script_.send(frame);
  script_.send(3);
  expect_frames({{1, 7, 0}, {2, 7, 0}, {3, 3, 0}});
  EXPECT_EQ(acquisition.state().frames.repeated, 0U);
  EXPECT_EQ(acquisition.state().frames.restarts, 2U);
}

TEST_F(AcquisitionOfScriptedCamera, TakesTheTimeThatWasRecordedAsItIs) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  Frame frame;
  frame.counter = 1;
  frame.device_time = 500;
  frame.host_time = 900000;
  frame.time = 123456789;
  script_.send(frame);
  expect_frames({{1, 1, 0}});
  EXPECT_EQ(recorder_.frames()[0].time, 123456789);
}

TEST_F(AcquisitionOfScriptedCamera, DropsAndCountsFramesWithAFaultAndTellsTheFirst) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.send(1);
  Frame damaged;
  for (const char* fault : {"cut off after 3 bytes", "cut off after 4 bytes"}) {
    damaged.fault = fault;
    script_.send(damaged);
  }
  script_.send(4);
  expect_frames({{1, 1, 0}, {1, 4, 0}});
  const auto state = acquisition.state();
  EXPECT_EQ(state.frames.unusable, 2U);
  EXPECT_EQ(state.frames.lost, 2U) << "a gap in the counter";
  EXPECT_EQ(state.fault, "cut off after 4 bytes");
  ASSERT_EQ(recorder_.troubles().size(), 1U);
  EXPECT_NE(recorder_.troubles()[0].find("after 3 bytes"), std::string::npos);
  EXPECT_TRUE(state.connected);
}

TEST_F(AcquisitionOfScriptedCamera, MapsTheCamerasClockToTheHosts) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.send(1, 5000);
  script_.send(2, 6000);
  expect_frames({{1, 1, 0}, {1, 2, 0}});
  EXPECT_EQ(recorder_.frames()[1].time, 1000006000);
}

TEST_F(AcquisitionOfScriptedCamera, KeepsItsClockMapWhereAFrameComesLate) {
  Acquisition& acquisition = start();
  acquisition.set(AcquisitionMode::kReliefOnly, Trigger::kExternal);
  script_.send(1, 5000);
  script_.send(3, 7000, 0, 2000000);
  script_.send(2, 6000, 0, 9000000);  // overtaken by the one before
  script_.send(4, 8000, 0, 2000000);
  expect_frames({{1, 1, 0}, {1, 3, 0}, {1, 2, 0}, {1, 4, 0}});
  const auto frames = recorder_.frames();
  EXPECT_EQ(frames[2].time, 1000006000);
  EXPECT_EQ(frames[3].time, 1000008000);
}
