// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <scan_cell_msgs/FrameInfo.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <memory>
#include <string>

#include "aravis/fake_cameras.h"
#include "aravis/line_camera.h"
#include "node/topic.h"

namespace camera_node_test {

using fake_cameras::LineCamera;
using fake_cameras::wait_until;
using scan_cell_msgs::PeakProfile;
using scan_cell_msgs::SetAcquisition;

/// The camera's node with a camera that shows a known line, its topics and its services.
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

  /// Starts free run with these settings.
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

  inline static std::unique_ptr<LineCamera> camera_;
  Topic<PeakProfile> profiles_{"camera/profiles"};
  Topic<sensor_msgs::Image> images_{"camera/image_raw"};
  Topic<sensor_msgs::CameraInfo> camera_infos_{"camera/camera_info"};
  Topic<scan_cell_msgs::FrameInfo> frame_infos_{"camera/frame_info"};
  Topic<diagnostic_msgs::DiagnosticArray> diagnostics_{"/diagnostics"};
};

}  // namespace camera_node_test
