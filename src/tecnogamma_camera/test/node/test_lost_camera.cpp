// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The node without a camera, or with parameters that it cannot use.
#include <cstdio>

#include "node/camera_node.h"

using namespace camera_node_test;  // NOLINT

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

/// The last test of the last file: it leaves another camera behind.
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
