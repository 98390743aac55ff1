// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// What the node publishes.
#include <cmath>
#include <map>

#include "node/camera_node.h"

using namespace camera_node_test;  // NOLINT

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
  // Messages published before the answer may still be in transit; one diagnosis later they are
  // here.
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

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_camera_node");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
