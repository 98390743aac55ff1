// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/UInt8.h>
#include <unistd.h>

#include <filesystem>

#include "../src/ros/bag_recording.h"

namespace fs = std::filesystem;

using tecnogamma_camera::kNoFrameNumber;
using tecnogamma_camera::open_bag_recording;
using tecnogamma_camera::Region;

namespace {

class BagRecording : public testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }

  static ros::Time stamp(int frame) { return ros::Time(1700000000 + frame, 7); }

  static sensor_msgs::Image image(int frame, const std::string& encoding = "mono8") {
    sensor_msgs::Image image;
    image.header.stamp = stamp(frame);
    image.encoding = encoding;
    image.width = 6;
    image.height = 4;
    image.step = encoding == "mono16" ? 12 : 6;
    image.data.assign(static_cast<std::size_t>(image.step) * image.height,
                      static_cast<std::uint8_t>(frame));
    return image;
  }

  static sensor_msgs::CameraInfo info(int frame, int first_row) {
    sensor_msgs::CameraInfo info;
    info.header.stamp = stamp(frame);
    info.width = 2048;
    info.height = 1088;
    info.roi.x_offset = 10;
    info.roi.y_offset = static_cast<std::uint32_t>(first_row);
    info.roi.width = 6;
    info.roi.height = 4;
    return info;
  }

  static scan_cell_msgs::PeakProfile profile(int frame) {
    scan_cell_msgs::PeakProfile profile;
    profile.header.stamp = stamp(frame);
    profile.acquisition = 1;
    profile.frame_counter = static_cast<std::uint64_t>(500 + frame);
    profile.device_time = static_cast<std::uint64_t>(1000 + frame);
    return profile;
  }

  template <class Message>
  void write(const std::string& topic, const Message& message) {
    const auto mode = fs::exists(path_) ? rosbag::bagmode::Append : rosbag::bagmode::Write;
    rosbag::Bag bag(path_, mode);
    bag.write(topic, ros::Time(1700000000 + ++written_), message);
  }

  std::string refusal(const std::string& topic = "") {
    try {
      open_bag_recording(path_, topic);
    } catch (const scan_cell_common::Error& error) {
      return error.what();
    }
    return "nothing";
  }

  std::string path_ =
      (fs::temp_directory_path() / ("recording_" + std::to_string(getpid()) + ".bag")).string();
  unsigned written_ = 0;
};

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_F(BagRecording, NumbersImagesFromOneWhereTheBagHasNoProfiles) {
  for (int frame = 0; frame < 3; ++frame)
    write("/camera/image_raw", image(frame));
  const auto recording = open_bag_recording(path_, "");
  for (int turn = 0; turn < 2; ++turn) {
    for (int frame = 0; frame < 3; ++frame) {
      const auto found = recording->next();
      ASSERT_TRUE(found);
      EXPECT_EQ(found->counter, static_cast<std::uint64_t>(frame + 1));
      EXPECT_EQ(found->device_time, 0);
      EXPECT_EQ(found->time, static_cast<std::int64_t>(stamp(frame).toNSec()));
      EXPECT_EQ(found->image.as<std::uint8_t>().row(3)[5], frame);
    }
    EXPECT_FALSE(recording->next());
    recording->rewind();
  }
  EXPECT_EQ(recording->describe().region, (Region{0, 0, 6, 4}));
}

TEST_F(BagRecording, HasNoNumberForAnImageWhoseProfileIsMissing) {
  write("/camera/profiles", profile(0));
  write("/camera/image_raw", image(0));
  write("/camera/image_raw", image(1));
  const auto recording = open_bag_recording(path_, "");
  EXPECT_EQ(recording->next()->counter, 500U);
  EXPECT_EQ(recording->next()->counter, kNoFrameNumber) << "nothing is guessed";
}

TEST_F(BagRecording, KeepsSixteenBits) {
  write("/camera/image_raw", image(5, "mono16"));
  write("/camera/image_raw", image(6));
  sensor_msgs::Image big_endian = image(7, "mono16");
  big_endian.is_bigendian = 1;
  write("/camera/image_raw", big_endian);
  const auto recording = open_bag_recording(path_, "");
  EXPECT_EQ(recording->describe().grey_bits, 16);
  const auto deep = recording->next();
  ASSERT_EQ(deep->fault, "");
  EXPECT_EQ(deep->image.as<std::uint16_t>().row(3)[5], 0x0505);
  EXPECT_TRUE(holds(recording->next()->fault, "unlike the first"));
  EXPECT_TRUE(holds(recording->next()->fault, "big-endian"));
}

TEST_F(BagRecording, MakesFaultsOfImagesThatLie) {
  write("/camera/image_raw", image(0));
  sensor_msgs::Image lie = image(1);
  lie.step = 5;
  write("/camera/image_raw", lie);
  lie = image(2);
  lie.step = 4000000000U;
  write("/camera/image_raw", lie);
  lie = image(3);
  lie.width = lie.height = 0;
  write("/camera/image_raw", lie);
  lie = image(4);
  lie.data.clear();
  write("/camera/image_raw", lie);
  const auto recording = open_bag_recording(path_, "");
  EXPECT_EQ(recording->next()->fault, "");
  for (int frame = 1; frame < 5; ++frame) {
    const auto found = recording->next();
    EXPECT_NE(found->fault, "") << frame;
    EXPECT_EQ(found->image.pixels, nullptr) << frame;
  }
}

TEST_F(BagRecording, AsksWhichOfSeveralTopicsIsMeant) {
  write("/left/image_raw", image(0));
  write("/right/image_raw", image(1));
  EXPECT_TRUE(holds(refusal(), "/left/image_raw, /right/image_raw")) << refusal();
  EXPECT_TRUE(holds(refusal("/middle"), "no images on /middle"));
  EXPECT_EQ(
      open_bag_recording(path_, "/right/image_raw")->next()->image.as<std::uint8_t>().row(0)[0], 1);
}

TEST_F(BagRecording, RefusesARegionThatChangesWithin) {
  write("/camera/image_raw", image(0));
  write("/camera/camera_info", info(0, 100));
  EXPECT_EQ(refusal(), "nothing");
  EXPECT_EQ(open_bag_recording(path_, "")->describe().region, (Region{10, 100, 6, 4}));
  write("/camera/camera_info", info(1, 101));
  EXPECT_TRUE(holds(refusal(), "region changes")) << refusal();
}

TEST_F(BagRecording, RefusesBagsThatCannotBeUsedAndSaysWhy) {
  EXPECT_TRUE(holds(refusal(), path_)) << "missing";
  write("/camera/nothing", std_msgs::UInt8());
  EXPECT_TRUE(holds(refusal(), "holds no images"));
  write("/camera/image_raw", image(0));
  write("/camera/profiles", std_msgs::UInt8());
  EXPECT_TRUE(holds(refusal(), "/camera/profiles has another definition")) << refusal();
  fs::resize_file(path_, fs::file_size(path_) / 2);
  EXPECT_TRUE(holds(refusal(), path_)) << refusal();
  fs::resize_file(path_, 3);
  EXPECT_TRUE(holds(refusal(), path_)) << refusal();
}
