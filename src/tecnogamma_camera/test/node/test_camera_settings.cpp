// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// Settings changed by requests and by dynamic_reconfigure.
#include <cmath>

#include "node/camera_node.h"

using namespace camera_node_test;  // NOLINT

TEST_F(CameraNode, RefusesModesThatDoNotExist) {
  const auto answer = set(9);
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("mode"), std::string::npos);
}

TEST_F(CameraNode, ChangesTheDetectorWhileRunningAndTheRegionOnlyInStop) {
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY).success);
  EXPECT_EQ(reconfigure("trigger_level", 250), 250);  // above the line: no peaks any more
  profiles_.forget();
  EXPECT_TRUE(wait_until([this] {
    const auto profiles = profiles_.messages();
    return !profiles.empty() && std::isnan(profiles.back().position[10]);
  }));
  EXPECT_EQ(reconfigure("trigger_level", 60), 60);
  EXPECT_EQ(reconfigure("region_height", 32), 64);  // refused
  set(SetAcquisition::Request::STOP);
  EXPECT_EQ(reconfigure("region_height", 32), 32);
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY).success);
  EXPECT_TRUE(wait_until([this] {
    const auto profiles = profiles_.messages();
    return !profiles.empty() && profiles.back().position.size() == 32;
  }));
  set(SetAcquisition::Request::STOP);
  EXPECT_EQ(reconfigure("region_height", 64), 64);
}

TEST_F(CameraNode, SaysThatTheCamerasOwnExposureCannotBeHadBack) {
  EXPECT_EQ(expose(0.004), 0.004);
  EXPECT_EQ(expose(0), 0.004);  // refused: the value shown is the one in the camera
}

TEST_F(CameraNode, StartsWithExposureAndRegionOfTheRequestAndTellsWhatTheCameraTook) {
  const auto before = set(SetAcquisition::Request::STOP);
  EXPECT_EQ(before.taken.region_width, 256U);
  const auto started = set(SetAcquisition::Request::RELIEF_ONLY, 0.003, 128, 0);
  ASSERT_TRUE(started.success) << started.message;
  EXPECT_GT(started.acquisition, 0U);
  EXPECT_EQ(started.settings.exposure, 0.003);
  EXPECT_EQ(started.settings.region_height, 0U);  // as asked for: to the sensor's edge
  EXPECT_NEAR(started.taken.exposure, 0.003, 1e-6);
  EXPECT_EQ(started.taken.region_x, 64U);
  EXPECT_EQ(started.taken.region_width, 128U);
  EXPECT_EQ(started.taken.region_height, 2048U - 32U);
  EXPECT_TRUE(wait_until([this] {
    const auto profiles = profiles_.messages();
    return !profiles.empty() && profiles.back().position.size() == 2048 - 32;
  }));
  EXPECT_EQ(reconfigure("region_width", 128), 128) << "dynamic_reconfigure must know";
  const auto restored = set(SetAcquisition::Request::STOP, 0.004, 256);
  EXPECT_TRUE(restored.success) << restored.message;
  EXPECT_EQ(restored.acquisition, 0U);
  EXPECT_EQ(restored.taken.region_height, 64U);
}

TEST_F(CameraNode, RefusesSettingsByFieldValueAndCureAndKeepsWhatItHad) {
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY, 0.004, 256).success);
  const auto refused = [](double exposure, int width, const std::string& why) {
    const auto answer = set(SetAcquisition::Request::RELIEF_ONLY, exposure, width);
    EXPECT_FALSE(answer.success) << why;
    EXPECT_NE(answer.message.find(why), std::string::npos) << answer.message;
    EXPECT_EQ(answer.settings.exposure, 0.004) << why;
    EXPECT_EQ(answer.settings.region_width, 256U) << why;
    EXPECT_EQ(answer.taken.region_width, 256U) << why;
    EXPECT_NEAR(answer.taken.exposure, 0.004, 1e-6) << why;
  };
  refused(std::nan(""), 256, "exposure: nan s; give 0 .. 10 s");
  refused(11, 256, "exposure: 11 s; give 0 .. 10 s");
  refused(0, 256,
          "exposure: 0 s: the camera's own exposure has been overwritten; give a value above 0");
  refused(0.004, 70'000, "region_width: 70000 px; give 0 .. 65535 px");
  refused(0.004, 4096, "region: 4096 x 64 at 64, 32; the sensor has 2048 x 2048 pixels");
  refused(1e-9, 128, "exposure: 1e-09 s; this camera takes");  // the region was written already
}

TEST_F(CameraNode, ChangesRateGainDetectorChoiceAndLiveRatioWhileItRuns) {
  const auto before = set(SetAcquisition::Request::RELIEF_LIVE).settings;
  EXPECT_EQ(before.detector, "fir_derivative");
  EXPECT_EQ(before.choice, "brightest");
  EXPECT_EQ(before.live_ratio, 5U);
  EXPECT_EQ(before.rate, 50);
  SetAcquisition call;
  call.request.mode = SetAcquisition::Request::RELIEF_LIVE;
  call.request.change_settings = true;
  call.request.settings.exposure = 0.004;
  call.request.settings.region_x = 64;
  call.request.settings.region_y = 32;
  call.request.settings.region_width = 256;
  call.request.settings.region_height = 64;
  const scan_cell_msgs::CameraSettings plain = call.request.settings;
  call.request.settings.rate = 40;
  call.request.settings.set_gain = true;
  call.request.settings.gain = 3;
  call.request.settings.detector = "threshold";
  call.request.settings.choice = "last";
  call.request.settings.live_ratio = 1;
  ASSERT_TRUE(ros::service::call("camera/set_acquisition", call));
  ASSERT_TRUE(call.response.success) << call.response.message;
  EXPECT_EQ(call.response.settings.rate, 40);
  EXPECT_TRUE(call.response.settings.set_gain);
  EXPECT_EQ(call.response.settings.gain, 3);
  EXPECT_EQ(call.response.settings.detector, "threshold");
  EXPECT_EQ(call.response.settings.choice, "last");
  profiles_.forget();
  images_.forget();
  ASSERT_TRUE(wait_until([this] { return profiles_.count() >= 20; }));
  EXPECT_TRUE(wait_until([this] { return images_.count() + 2 >= profiles_.count(); }));
  for (const PeakProfile& profile : profiles_.messages()) {
    if (profile.packets_lost > 0) continue;
    EXPECT_NEAR(profile.position[5], LineCamera::line(37), 0.2) << "another detector, one line";
  }

  call.request.settings = plain;  // the others are left out
  ASSERT_TRUE(ros::service::call("camera/set_acquisition", call));
  EXPECT_EQ(call.response.settings.detector, "threshold");
  EXPECT_EQ(call.response.settings.live_ratio, 1U);
  EXPECT_EQ(call.response.settings.rate, 40);

  call.request.settings = before;  // what was answered can be given back
  call.request.settings.exposure = 0.004;
  ASSERT_TRUE(ros::service::call("camera/set_acquisition", call));
  ASSERT_TRUE(call.response.success) << call.response.message;
  EXPECT_EQ(call.response.settings.detector, "fir_derivative");
  EXPECT_EQ(call.response.settings.live_ratio, 5U);
}

TEST_F(CameraNode, RefusesADetectorThatThereIsNotAndKeepsTheOneItHas) {
  SetAcquisition call;
  call.request.mode = SetAcquisition::Request::STOP;
  call.request.change_settings = true;
  call.request.settings.exposure = 0.004;
  const auto refused = [&](const std::string& why) {
    ASSERT_TRUE(ros::service::call("camera/set_acquisition", call));
    EXPECT_FALSE(call.response.success) << why;
    EXPECT_NE(call.response.message.find(why), std::string::npos) << call.response.message;
    EXPECT_EQ(call.response.settings.detector, "fir_derivative");
    EXPECT_EQ(call.response.settings.choice, "brightest");
    EXPECT_EQ(call.response.settings.live_ratio, 5U);
  };
  call.request.settings.detector = "parabola";
  call.request.settings.live_ratio = 2;
  refused("detector: 'parabola'; give threshold");
  call.request.settings.detector = "";
  call.request.settings.choice = "nearest";
  refused("choice: 'nearest'; give brightest, first or last");
  call.request.settings.choice = "";
  call.request.settings.rate = -1;
  refused("rate: -1 Hz; give 0 .. 100000 Hz");
  call.request.settings.rate = 0;
  call.request.settings.set_gain = true;
  call.request.settings.gain = 2000;
  refused("gain: 2000; give 0 .. 1000");
}

TEST_F(CameraNode, ChangesNothingThatComesWithADetectorThatThereIsNot) {
  const int level = reconfigure("trigger_level", 60);
  dynamic_reconfigure::Reconfigure call;
  call.request.config.strs.resize(1);
  call.request.config.strs[0].name = "detector";
  call.request.config.strs[0].value = "parabola";
  call.request.config.ints.resize(1);
  call.request.config.ints[0].name = "trigger_level";
  call.request.config.ints[0].value = level + 7;
  ASSERT_TRUE(ros::service::call("camera/set_parameters", call));
  int shown = -1;
  for (const auto& entry : call.response.config.ints)
    if (entry.name == "trigger_level") shown = entry.value;
  EXPECT_EQ(shown, level) << "shown, but not in force";
}
