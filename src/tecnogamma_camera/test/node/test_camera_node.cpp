// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/FrameInfo.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "aravis/fake_cameras.h"
#include "aravis/line_camera.h"
#include "node/topic.h"

using fake_cameras::LineCamera;
using fake_cameras::wait_until;
using scan_cell_msgs::PeakProfile;
using scan_cell_msgs::SetAcquisition;

namespace {

class CameraNode : public testing::Test {
 protected:
  static void SetUpTestSuite() { camera_ = std::make_unique<LineCamera>(); }
  static void TearDownTestSuite() { camera_.reset(); }

  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("camera/set_acquisition", ros::Duration(60)));
    ASSERT_TRUE(
        wait_until([this] { return profiles_.has_publisher() && images_.has_publisher(); }));
  }
  void TearDown() override { set(SetAcquisition::Request::STOP); }

  SetAcquisition::Response set(int mode, int trigger = SetAcquisition::Request::FREE_RUN) {
    SetAcquisition call;
    call.request.mode = mode;
    call.request.trigger = trigger;
    EXPECT_TRUE(ros::service::call("camera/set_acquisition", call));
    return call.response;
  }

  /// In free run, with these settings.
  static SetAcquisition::Response set(int mode, double exposure, int region_width,
                                      int region_height = 64) {
    SetAcquisition call;
    call.request.mode = mode;
    call.request.change_settings = true;
    call.request.settings.exposure = exposure;
    call.request.settings.region_x = 64;
    call.request.settings.region_y = 32;
    call.request.settings.region_width = region_width;
    call.request.settings.region_height = region_height;
    EXPECT_TRUE(ros::service::call("camera/set_acquisition", call));
    return call.response;
  }

  /// The value that the node settled on.
  static int reconfigure(const std::string& name, int value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.ints.resize(1);
    call.request.config.ints[0].name = name;
    call.request.config.ints[0].value = value;
    EXPECT_TRUE(ros::service::call("camera/set_parameters", call));
    for (const auto& entry : call.response.config.ints)
      if (entry.name == name) return entry.value;
    return -1;
  }

  /// The exposure that the node settled on. [s]
  static double expose(double value) {
    dynamic_reconfigure::Reconfigure call;
    call.request.config.doubles.resize(1);
    call.request.config.doubles[0].name = "exposure";
    call.request.config.doubles[0].value = value;
    EXPECT_TRUE(ros::service::call("camera/set_parameters", call));
    for (const auto& answer : call.response.config.doubles)
      if (answer.name == "exposure") return answer.value;
    return -1;
  }

  /// Level of the newest diagnostics; -1 before the first.
  int diagnosed() {
    int level = -1;
    for (const auto& array : diagnostics_.messages())
      for (const auto& status : array.status)
        if (status.name.find("camera") != std::string::npos) level = status.level;
    return level;
  }

  static std::unique_ptr<LineCamera> camera_;
  Topic<PeakProfile> profiles_{"camera/profiles"};
  Topic<sensor_msgs::Image> images_{"camera/image_raw"};
  Topic<sensor_msgs::CameraInfo> camera_infos_{"camera/camera_info"};
  Topic<scan_cell_msgs::FrameInfo> frame_infos_{"camera/frame_info"};
  Topic<diagnostic_msgs::DiagnosticArray> diagnostics_{"/diagnostics"};
};

std::unique_ptr<LineCamera> CameraNode::camera_;

}  // namespace

TEST_F(CameraNode, PublishesTheLineInSensorCoordinates) {
  const auto started = set(SetAcquisition::Request::RELIEF_ONLY);
  ASSERT_TRUE(started.success) << started.message;
  ASSERT_TRUE(wait_until([this] { return profiles_.count() >= 20; }));
  for (const PeakProfile& profile : profiles_.messages()) {
    EXPECT_EQ(profile.acquisition, started.acquisition);
    EXPECT_EQ(profile.header.frame_id, "camera_optical_frame");
    EXPECT_EQ(profile.laser, PeakProfile::LASER_UNKNOWN);
    EXPECT_GT(profile.device_time, 0U);
    EXPECT_LT(std::abs((ros::Time::now() - profile.header.stamp).toSec()), 60);
    EXPECT_EQ(profile.first_row, 32U);
    ASSERT_EQ(profile.position.size(), 64U);
    ASSERT_EQ(profile.width.size(), 64U);
    ASSERT_EQ(profile.intensity.size(), 64U);
    if (profile.packets_lost > 0) continue;
    for (int row = 0; row < 64; ++row)
      EXPECT_NEAR(profile.position[row], LineCamera::line(32 + row), 0.02);
  }
  EXPECT_EQ(images_.count(), 0U);
}

TEST_F(CameraNode, PublishesImagesWithTheirCameraInfo) {
  ASSERT_TRUE(set(SetAcquisition::Request::LIVE_ONLY).success);
  sensor_msgs::Image image;
  sensor_msgs::CameraInfo info;
  // The first of either topic may be missed while its subscriber connects.
  const auto find_pair = [&] {
    for (const sensor_msgs::Image& each : images_.messages()) {
      for (const sensor_msgs::CameraInfo& other : camera_infos_.messages()) {
        if (other.header.stamp != each.header.stamp) continue;
        image = each;
        info = other;
        return true;
      }
    }
    return false;
  };
  ASSERT_TRUE(wait_until(find_pair)) << "no image has a camera info of its own stamp";
  EXPECT_EQ(profiles_.count(), 0U);
  EXPECT_EQ(image.encoding, "mono8");
  EXPECT_EQ(image.width, 256U);
  EXPECT_EQ(image.height, 64U);
  EXPECT_EQ(image.data.size(), 256U * 64U);
  EXPECT_EQ(info.width, 2048U);
  EXPECT_EQ(info.roi.x_offset, 64U);
  EXPECT_EQ(info.roi.y_offset, 32U);
  EXPECT_EQ(info.roi.width, 256U);
  EXPECT_EQ(info.K[0], 901.5);
  EXPECT_EQ(info.K[5], 1030);
  EXPECT_EQ(info.D.size(), 5U);
}

TEST_F(CameraNode, PublishesAnImageWithEveryFifthProfileWhereToldSo) {
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_LIVE).success);
  ASSERT_TRUE(wait_until([this] { return profiles_.count() >= 50; }));
  set(SetAcquisition::Request::STOP);
  EXPECT_TRUE(wait_until([this] {
    const double expected = static_cast<double>(profiles_.count()) / 5;
    return std::abs(static_cast<double>(images_.count()) - expected) <= 2;
  }));
}

TEST_F(CameraNode, PublishesOneProfileAPulseInExternalTrigger) {
  ASSERT_TRUE(
      set(SetAcquisition::Request::RELIEF_ONLY, SetAcquisition::Request::EXTERNAL_TRIGGER).success);
  for (std::size_t pulse = 1; pulse <= 10; ++pulse) {
    camera_->pulse();
    ASSERT_TRUE(wait_until([&] { return profiles_.count() >= pulse; })) << pulse;
  }
  const auto profiles = profiles_.messages();
  ASSERT_EQ(profiles.size(), 10U);
  for (std::size_t i = 1; i < profiles.size(); ++i)
    EXPECT_EQ(profiles[i].frame_counter, profiles[i - 1].frame_counter + 1);
}

TEST_F(CameraNode, PublishesNothingOnceItAnsweredAStop) {
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_LIVE).success);
  ASSERT_TRUE(wait_until([this] { return profiles_.count() >= 5; }));
  EXPECT_EQ(set(SetAcquisition::Request::STOP).acquisition, 0U);
  // What was published before the answer may still be on its way; a diagnosis later it is here.
  const auto a_diagnosis = [this] {
    const std::size_t before = diagnostics_.count();
    return wait_until([&] { return diagnostics_.count() > before; });
  };
  ASSERT_TRUE(a_diagnosis());
  profiles_.forget();
  images_.forget();
  ASSERT_TRUE(a_diagnosis());
  EXPECT_EQ(profiles_.count(), 0U);
  EXPECT_EQ(images_.count(), 0U);
  EXPECT_EQ(diagnosed(), diagnostic_msgs::DiagnosticStatus::OK);
}

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

TEST_F(CameraNode, TellsTheNumberOfEachImageBesideIt) {
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_LIVE).success);
  std::map<std::int64_t, std::uint64_t> numbers;  // of the profiles, by their stamp
  const auto number_all = [&] {
    for (const PeakProfile& profile : profiles_.messages())
      numbers[static_cast<std::int64_t>(profile.header.stamp.toNSec())] = profile.frame_counter;
    std::size_t found = 0;
    for (const sensor_msgs::Image& image : images_.messages()) {
      for (const scan_cell_msgs::FrameInfo& info : frame_infos_.messages()) {
        if (info.header.stamp != image.header.stamp) continue;
        const auto number = numbers.find(static_cast<std::int64_t>(info.header.stamp.toNSec()));
        if (number == numbers.end()) continue;
        EXPECT_EQ(info.frame_counter, number->second);
        EXPECT_EQ(info.first_column, 64U);
        EXPECT_EQ(info.first_row, 32U);
        EXPECT_EQ(info.decimation, 1U);
        ++found;
      }
    }
    return found >= 5;
  };
  EXPECT_TRUE(wait_until(number_all)) << "no image has a number of its own stamp";
}

TEST_F(CameraNode, RefusesToStartWithABadParameterAndNamesIt) {
  for (const std::string bad : {"trigger_level:=70000", "detector:=parabola", "exposre:=0.01",
                                "scanner_model:=/no/such/file.yaml", "payload:=range_map",
                                "scan_rows:=0", "playback_speed:=-1"}) {
    const std::string command = std::string(CAMERA_NODE) + " __name:=bad_camera _" + bad + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    ASSERT_NE(pipe, nullptr);
    std::string output;
    char buffer[256];
    while (fgets(buffer, sizeof buffer, pipe))
      output += buffer;
    EXPECT_EQ(WEXITSTATUS(pclose(pipe)), 1) << output;
    const std::string culprit =
        bad.find("/no/such") == std::string::npos ? bad.substr(0, bad.find(':')) : "/no/such";
    EXPECT_NE(output.find(culprit), std::string::npos) << output;
    ros::param::del("bad_camera");
  }
}

/// The last test: it leaves another camera behind.
TEST_F(CameraNode, SaysThatTheCameraIsLostAndResumesTheTriggerWhenItIsBack) {
  const auto started =
      set(SetAcquisition::Request::RELIEF_ONLY, SetAcquisition::Request::EXTERNAL_TRIGGER);
  ASSERT_TRUE(started.success);
  camera_.reset();
  EXPECT_TRUE(
      wait_until([this] { return diagnosed() == diagnostic_msgs::DiagnosticStatus::ERROR; }));
  profiles_.forget();

  camera_ = std::make_unique<LineCamera>();
  EXPECT_TRUE(wait_until([this] { return diagnosed() == diagnostic_msgs::DiagnosticStatus::OK; }));
  EXPECT_TRUE(wait_until([this] {
    camera_->pulse();
    ros::Duration(0.05).sleep();
    return profiles_.count() >= 1;
  }));
  for (const PeakProfile& profile : profiles_.messages())
    EXPECT_GT(profile.acquisition, started.acquisition);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_camera_node");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
