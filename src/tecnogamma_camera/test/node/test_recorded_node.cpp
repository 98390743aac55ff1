// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <scan_cell_msgs/SetAcquisition.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "aravis/fake_cameras.h"
#include "node/topic.h"
#include "payload/payloads.h"
#include "peaks/stripes.h"

namespace fs = std::filesystem;

using fake_cameras::wait_until;
using scan_cell_msgs::PeakProfile;
using scan_cell_msgs::SetAcquisition;

namespace {

constexpr int kColumns = 120, kRows = 16, kFirstColumn = 64, kFirstRow = 32;
constexpr std::uint64_t kStart = 1700000000000000000;  // [ns] when it was recorded
constexpr std::uint64_t kStep = 2000000;               // [ns] from frame to frame

/// Sensor column of the line in a frame.
double line(int frame) {
  return kFirstColumn + 40 + 0.3 * frame;
}

std::vector<std::uint8_t> picture(int frame) {
  stripes::Image image(kColumns, kRows, 10);
  for (int row = 0; row < kRows; ++row)
    image.add(row, {line(frame) - kFirstColumn, 1.5, 200});
  const auto view = image.view();
  return {view.row(0), view.row(0) + kColumns * kRows};
}

/// The node as a separate process.
class Node {
 public:
  explicit Node(std::vector<std::string> parameters) {
    parameters.insert(parameters.begin(), {CAMERA_NODE, "__name:=recorded"});
    std::vector<char*> arguments;
    for (std::string& parameter : parameters)
      arguments.push_back(parameter.data());
    arguments.push_back(nullptr);
    process_ = fork();
    if (process_ == 0) {
      execv(arguments[0], arguments.data());
      _exit(127);
    }
  }
  ~Node() {
    kill(process_, SIGINT);
    waitpid(process_, nullptr, 0);
    ros::param::del("recorded");
  }
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;

 private:
  pid_t process_;
};

class RecordedNode : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override {
    node_.reset();
    fs::remove_all(folder_);
  }

  void start(const std::vector<std::string>& parameters) {
    node_ = std::make_unique<Node>(parameters);
    ASSERT_TRUE(ros::service::waitForService("recorded/set_acquisition", ros::Duration(60)));
    ASSERT_TRUE(wait_until([this] {
      return profiles_.has_publisher() && images_.has_publisher() && infos_.has_publisher();
    }));
  }

  SetAcquisition::Response set(int mode, int trigger = SetAcquisition::Request::EXTERNAL_TRIGGER) {
    SetAcquisition call;
    call.request.mode = mode;
    call.request.trigger = trigger;
    EXPECT_TRUE(ros::service::call("recorded/set_acquisition", call));
    return call.response;
  }

  /// A value of the newest diagnostics.
  std::string diagnosed(const std::string& key) {
    std::string value;
    for (const auto& array : diagnostics_.messages())
      for (const auto& status : array.status)
        for (const auto& entry : status.values)
          if (entry.key == key) value = entry.value;
    return value;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_ = fs::temp_directory_path() / ("recorded_node_" + std::to_string(getpid()));
  Topic<PeakProfile> profiles_{"recorded/profiles"};
  Topic<sensor_msgs::Image> images_{"recorded/image_raw"};
  Topic<sensor_msgs::CameraInfo> infos_{"recorded/camera_info"};
  Topic<diagnostic_msgs::DiagnosticArray> diagnostics_{"/diagnostics"};
  std::unique_ptr<Node> node_;
};

void expect_line(const PeakProfile& profile, int frame) {
  EXPECT_EQ(profile.first_row, static_cast<std::uint32_t>(kFirstRow));
  ASSERT_EQ(profile.position.size(), static_cast<std::size_t>(kRows));
  for (int row = 0; row < kRows; ++row)
    EXPECT_NEAR(profile.position[row], line(frame), 0.02) << frame << " " << row;
}

}  // namespace

TEST_F(RecordedNode, PlaysAFolderWithItsNumbersAndStamps) {
  constexpr int kFrames = 20;
  std::ofstream index(folder_ / "index.csv");
  index << "file,frame,device_time,time,first_column,first_row,sensor_columns,sensor_rows\n";
  for (int i = 0; i < kFrames; ++i) {
    std::vector<std::uint8_t> pixels = picture(i);
    const std::string name = std::to_string(i) + ".png";
    cv::imwrite(path(name), cv::Mat(kRows, kColumns, CV_8UC1, pixels.data()));
    const std::uint64_t time = kStep * static_cast<std::uint64_t>(i);
    index << name << "," << 65530 + i + (i > 9) << "," << 5000 + time << "," << kStart + time << ","
          << kFirstColumn << "," << kFirstRow << ",2048,1088\n";
  }
  index.close();
  start({"_camera:=folder:" + folder_.string(), "_live_ratio:=4"});
  const auto started = set(SetAcquisition::Request::RELIEF_LIVE);
  ASSERT_TRUE(started.success) << started.message;
  ASSERT_TRUE(wait_until([this] { return profiles_.count() == kFrames && images_.count() == 5; }));
  const auto profiles = profiles_.messages();
  for (int i = 0; i < kFrames; ++i) {
    const std::uint64_t time = kStep * static_cast<std::uint64_t>(i);
    EXPECT_EQ(profiles[i].frame_counter, 65530U + i + (i > 9));
    EXPECT_EQ(profiles[i].device_time, 5000 + time);
    EXPECT_EQ(profiles[i].header.stamp.toNSec(), kStart + time);
    EXPECT_EQ(profiles[i].acquisition, started.acquisition);
    expect_line(profiles[i], i);
  }
  EXPECT_EQ(infos_.messages().at(0).roi.x_offset, static_cast<std::uint32_t>(kFirstColumn));
  EXPECT_EQ(infos_.messages()[0].width, 2048U);
  EXPECT_TRUE(wait_until([this] { return diagnosed("frames lost") == "1"; }));
  EXPECT_TRUE(wait_until([this] { return diagnosed("mode") == "stopped"; })) << "it has ended";
}

TEST_F(RecordedNode, PlaysABagWithTheNumbersOfItsProfilesAndCountsImagesItCannotUse) {
  constexpr int kFrames = 12, kColour = 5, kCut = 7;
  {
    rosbag::Bag bag(path("live.bag"), rosbag::bagmode::Write);
    for (int i = 0; i < kFrames; ++i) {
      const std::uint64_t time = kStart + kStep * static_cast<std::uint64_t>(i);
      sensor_msgs::Image image;
      image.header.stamp.fromNSec(time);
      image.encoding = i == kColour ? "rgb8" : "mono8";
      image.width = image.step = kColumns;
      image.height = kRows;
      image.data = picture(i);
      if (i == kCut) image.data.resize(100);
      sensor_msgs::CameraInfo info;
      info.header = image.header;
      info.width = 2048;
      info.height = 1088;
      info.roi.x_offset = kFirstColumn;
      info.roi.y_offset = kFirstRow;
      info.roi.width = kColumns;
      info.roi.height = kRows;
      PeakProfile profile;
      profile.header = image.header;
      profile.acquisition = i < 10 ? 3 : 4;
      profile.frame_counter = static_cast<std::uint64_t>(i < 10 ? 900 + i : i);
      profile.device_time = 1000000 + kStep * static_cast<std::uint64_t>(i);
      bag.write("/cell/camera/profiles", image.header.stamp, profile);
      bag.write("/cell/camera/image_raw", image.header.stamp, image);
      bag.write("/cell/camera/camera_info", image.header.stamp, info);
    }
  }
  start({"_camera:=bag:" + path("live.bag"), "_playback_speed:=0"});
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY).success);
  ASSERT_TRUE(wait_until([this] { return profiles_.count() == kFrames - 2; }));
  int i = 0;
  for (const PeakProfile& profile : profiles_.messages()) {
    i += i == kColour || i == kCut;
    EXPECT_EQ(profile.frame_counter, static_cast<std::uint64_t>(i < 10 ? 900 + i : i));
    EXPECT_EQ(profile.acquisition, i < 10 ? 1U : 2U) << "two starts were recorded";
    EXPECT_EQ(profile.device_time, 1000000 + kStep * static_cast<std::uint64_t>(i));
    EXPECT_EQ(profile.header.stamp.toNSec(), kStart + kStep * static_cast<std::uint64_t>(i));
    expect_line(profile, i);
    ++i;
  }
  EXPECT_TRUE(wait_until([this] { return diagnosed("frames unusable") == "2"; }));
  EXPECT_NE(diagnosed("last fault").find("100 bytes"), std::string::npos);
}

TEST_F(RecordedNode, PublishesThePeaksOfRecordedReliefFramesAsTheyCame) {
  constexpr int kFrames = 6, kTorn = 2, kCut = 4;
  for (int i = 0; i < kFrames; ++i) {
    payloads::Relief relief;
    relief.counter = static_cast<std::uint16_t>(65533 + i);
    relief.time = 0xFFFFFFF0 + static_cast<std::uint32_t>(i) * 8;
    relief.packets_lost = i == kTorn ? 2 : 0;
    for (int row = 0; row < 4; ++row)
      relief.center(40, 5, 42.25 + i);
    const std::string bytes = relief.bytes();
    std::ofstream(folder_ / (std::to_string(i) + ".bin"), std::ios::binary)
        << (i == kCut ? bytes.substr(0, 50) : bytes);
  }
  start({"_camera:=folder:" + folder_.string(), "_payload:=tecnogamma_relief",
         "_payload_tick:=1e-6", "_playback_speed:=0"});
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY).success);
  ASSERT_TRUE(wait_until([this] { return profiles_.count() == kFrames - 1; }));
  std::uint64_t i = 0;
  for (const PeakProfile& profile : profiles_.messages()) {
    i += i == kCut;
    EXPECT_EQ(profile.frame_counter, 65533 + i) << "unwrapped across 65535";
    EXPECT_EQ(profile.packets_lost, i == kTorn ? 2U : 0U);
    EXPECT_EQ(profile.first_row, 100U);
    ASSERT_EQ(profile.position.size(), 4U);
    if (i == kTorn) {
      EXPECT_TRUE(std::isnan(profile.position[0]));
    } else {
      EXPECT_EQ(profile.position[3], 64 + 42.25F + static_cast<float>(i));
      EXPECT_EQ(profile.width[3], 5);
    }
    EXPECT_EQ(profile.device_time - profiles_.messages()[0].device_time, 8000 * i);
    ++i;
  }
  EXPECT_TRUE(wait_until([this] { return diagnosed("frames unusable") == "1"; }));
}

TEST_F(RecordedNode, RunsItsOwnDetectorOnTheLiveFramesOfAHybridRecording) {
  for (int i = 0; i < 3; ++i) {
    payloads::Relief frame;
    frame.counter = static_cast<std::uint16_t>(10 + i);
    frame.kernels = 4;
    for (int row = 0; row < 4 && i != 1; ++row)
      frame.spot(40, 5);
    if (i == 1) {  // 128 x 4 pixels with the same line
      stripes::Image image(128, 4, 10);
      for (int row = 0; row < 4; ++row)
        image.add(row, {42, 1.5, 200});
      const auto view = image.view();
      frame.payload.assign(view.row(0), view.row(0) + 128 * 4);
    }
    std::ofstream(folder_ / (std::to_string(i) + ".bin"), std::ios::binary) << frame.bytes();
  }
  start({"_camera:=folder:" + folder_.string(), "_payload:=tecnogamma_relief", "_playback_speed:=0",
         "_live_ratio:=1"});
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_LIVE).success);
  ASSERT_TRUE(wait_until(
      [this] { return profiles_.count() == 3 && images_.count() == 1 && infos_.count() == 1; }));
  for (const PeakProfile& profile : profiles_.messages()) {
    EXPECT_EQ(profile.first_row, 100U);
    ASSERT_EQ(profile.position.size(), 4U);
    EXPECT_NEAR(profile.position[2], 64 + 42, 0.02) << profile.frame_counter;
  }
  EXPECT_EQ(images_.messages()[0].width, 128U);
  EXPECT_EQ(infos_.messages()[0].roi.x_offset, 64U);
  EXPECT_EQ(infos_.messages()[0].roi.height, 4U);
  EXPECT_EQ(infos_.messages()[0].width, 1696U);
}

TEST_F(RecordedNode, PublishesThePeaksOfRecorded3D03FramesOnTheTurnedSensor) {
  constexpr int kFrames = 3;
  for (int i = 0; i < kFrames; ++i) {
    payloads::Photonfocus sent(32, 2);
    for (int block = 0; block < 2; ++block) {
      const auto number = static_cast<std::uint32_t>(2 * i + block);
      sent.number(block, (0xFFFFFD + number) & 0xFFFFFF, 1000 * number);
      for (int column = 0; column < 32; ++column)
        sent.set(block, column, 14, 176, 10, 128);
    }
    cv::imwrite(path(std::to_string(i) + ".png"), cv::Mat(10, 32, CV_8UC1, sent.bytes.data()));
  }
  start({"_camera:=folder:" + folder_.string(), "_payload:=photonfocus_3d03",
         "_scan_first_row:=200", "_rate:=100"});
  ASSERT_TRUE(set(SetAcquisition::Request::RELIEF_ONLY).success);
  ASSERT_TRUE(wait_until([this] { return profiles_.count() == 2 * kFrames; }));
  const auto profiles = profiles_.messages();
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    EXPECT_EQ(profiles[i].frame_counter, 0xFFFFFD + i) << "unwrapped across 24 bits";
    EXPECT_EQ(profiles[i].first_row, 2048U - 32U);
    ASSERT_EQ(profiles[i].position.size(), 32U);
    EXPECT_EQ(profiles[i].position[7], 258.75);
    EXPECT_EQ(profiles[i].width[7], 10);
    EXPECT_EQ(profiles[i].device_time - profiles[0].device_time, 1000000 * i);
  }
  const auto live = set(SetAcquisition::Request::LIVE_ONLY, SetAcquisition::Request::FREE_RUN);
  EXPECT_FALSE(live.success) << "3Donly has no image";
  EXPECT_NE(live.message.find("no image"), std::string::npos) << live.message;
}

TEST_F(RecordedNode, SaysWhyARecordingCannotBePlayed) {
  start({"_camera:=bag:" + path("missing.bag"), "_start_timeout:=1", "_retry_period:=0.2"});
  const auto answer = set(SetAcquisition::Request::RELIEF_ONLY);
  EXPECT_FALSE(answer.success);
  EXPECT_NE(answer.message.find("missing.bag"), std::string::npos) << answer.message;
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_recorded_node");
  ros::AsyncSpinner spinner(2);
  spinner.start();
  return RUN_ALL_TESTS();
}
