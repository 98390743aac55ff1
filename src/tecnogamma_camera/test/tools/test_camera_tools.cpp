// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>

#include "aravis/line_camera.h"
#include "aravis/opened_camera.h"
#include "open_camera.h"
#include "tecnogamma_camera/peak_detector.h"

using fake_cameras::grab;
using fake_cameras::kAddress;
using fake_cameras::LineCamera;
using fake_cameras::open;
using fake_cameras::Program;
using tecnogamma_camera::Trigger;

TEST(CameraMenu, StopsTheCameraWhereAFrameCannotBeSaved) {
  const Program program;
  open();
  const auto folder = std::filesystem::temp_directory_path() / ("menu_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder / "image.png");  // a folder in the file's place
  const std::string command = "cd " + folder.string() + " && printf '2\\n4\\n4\\n6\\n' | " +
                              CAMERA_MENU + " --camera " + kAddress + " > log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(folder / "log");
  const std::string log{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(log.find("image.png: cannot be written"), std::string::npos) << log;
  EXPECT_EQ(log.find("is running"), std::string::npos) << log;
  std::filesystem::remove_all(folder);
}

TEST(RecordFrames, WritesAFolderThatPlaysAsTheCameraDid) {
  LineCamera line;
  open();
  const auto folder =
      std::filesystem::temp_directory_path() / ("frames_" + std::to_string(getpid()));
  const auto record = [&](const std::string& options) {
    return WEXITSTATUS(
        std::system((std::string(RECORD_FRAMES) + " --camera " + kAddress + " --output " +
                     folder.string() + " " + options + " > /dev/null 2>&1")
                        .c_str()));
  };
  ASSERT_EQ(record("--frames 5 --rate 50 --pixel-format Mono16 --region-x 64 --region-y 32 "
                   "--region-width 256 --region-height 64"),
            0);
  EXPECT_EQ(record("--frames 5"), 1) << "a recording is never overwritten";
  tecnogamma_camera::CameraOptions options;
  options.playback.speed = 0;
  const auto camera = tecnogamma_camera::open_camera("folder:" + folder.string(), options);
  EXPECT_EQ(camera->describe().sensor_columns, 2048);
  camera->start(Trigger::kFreeRun);
  std::uint64_t number = 0;
  scan_cell_common::Nanoseconds device_time = 0, time = 0;
  for (int i = 0; i < 5; ++i) {
    const auto frame = grab(*camera);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->counter, number);
    EXPECT_GT(frame->device_time, device_time);
    EXPECT_GT(frame->time, time);
    number = frame->counter;
    device_time = frame->device_time;
    time = frame->time;
    if (frame->packets_lost > 0) continue;
    tecnogamma_camera::PeakProfile profile;
    tecnogamma_camera::make_detector("center_of_gravity", {})->detect(frame->image, profile);
    ASSERT_EQ(profile.rows(), 64);
    EXPECT_EQ(profile.first_row, 32);
    EXPECT_NEAR(profile.position[7], LineCamera::line(39), 0.02);
  }
  EXPECT_THROW(grab(*camera), tecnogamma_camera::StreamEnded);
  std::filesystem::remove_all(folder);
}

TEST(RecordFrames, EndsAndKeepsWhatItHasWhereTheCameraIsLost) {
  auto program = std::make_unique<Program>();
  open();
  const auto folder = std::filesystem::temp_directory_path() / ("lost_" + std::to_string(getpid()));
  auto recorded = std::async(std::launch::async, [&] {
    return WEXITSTATUS(std::system((std::string(RECORD_FRAMES) + " --camera " + kAddress +
                                    " --output " + folder.string() +
                                    " --frames 100000 --rate 50 --region-width 64 "
                                    "--region-height 32 > /dev/null 2>&1")
                                       .c_str()));
  });
  EXPECT_TRUE(fake_cameras::wait_until([&] { return exists(folder / "0000003.pgm"); }));
  program.reset();
  ASSERT_EQ(recorded.wait_for(std::chrono::seconds(60)), std::future_status::ready);
  EXPECT_EQ(recorded.get(), 1);
  EXPECT_TRUE(exists(folder / "index.csv"));
  std::filesystem::remove_all(folder);
}
