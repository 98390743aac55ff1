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

namespace {

/// Output of the menu for typed keys, one per line, in a folder of its own.
class TypedMenu {
 public:
  TypedMenu() { std::filesystem::create_directories(folder_); }
  ~TypedMenu() { std::filesystem::remove_all(folder_); }
  TypedMenu(const TypedMenu&) = delete;
  TypedMenu& operator=(const TypedMenu&) = delete;

  std::string type(const std::string& keys, const std::string& options = "") const {
    std::ofstream(folder_ / "keys") << keys;
    const std::string command = "cd " + folder_.string() + " && timeout 120 " + CAMERA_MENU +
                                " --camera " + kAddress + " " + options + " < keys > log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(folder_ / "log");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

 private:
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("typed_" + std::to_string(getpid()));
};

}  // namespace

TEST(CameraMenu, DoesEachOfItsSixItems) {
  LineCamera line;
  open();
  const TypedMenu menu;
  const std::string log = menu.type("1\n3\n2\n3\n4\n5\n7\n6\n1\n");
  const auto has = [&](const std::string& text) { return log.find(text) != std::string::npos; };
  EXPECT_TRUE(has("1 camera\n")) << log;                                // 1
  EXPECT_TRUE(has("serial LINE, ")) << log;                             // 1
  EXPECT_TRUE(has("camera: not connected; connect (2) first")) << log;  // 3 before 2
  EXPECT_TRUE(has("connected to ")) << log;                             // 2
  EXPECT_TRUE(has("sensor 2048 x 2048, region ")) << log;               // 3
  EXPECT_TRUE(has("; triggered by ")) << log;                           // 3
  EXPECT_TRUE(has(" pixels in image.png")) << log;                      // 4
  EXPECT_TRUE(exists(menu.file("image.png")));
  EXPECT_TRUE(has(" peaks in ")) << log;  // 5
  std::ifstream peaks(menu.file("peaks.csv"));
  std::string head, first;
  ASSERT_TRUE(std::getline(peaks, head) && std::getline(peaks, first));
  EXPECT_EQ(head, "row,position,width,intensity");
  EXPECT_NEAR(std::stod(first.substr(first.find(',') + 1)), LineCamera::line(std::stoi(first)),
              0.02);
  EXPECT_TRUE(has("give a number from 1 to 6")) << log;  // 7
  EXPECT_EQ(log.find("1 camera\n"), log.rfind("1 camera\n")) << "6 ends it";
}

TEST(CameraMenu, SaysWhichInputItWaitedForAndDrivesTheOutputsThatAreNamed) {
  const std::string file = fake_cameras::genicam_file();
  LineCamera::Features()
      .words("LineSelector", {"Line0", "Line1"})
      .words("LineMode", {"Input", "Output"})
      .words("LineSource", {"Off", "ExposureActive"})
      .save(file);
  LineCamera line(file);
  open();
  const TypedMenu menu;
  const std::string log =
      menu.type("2\n3\n4\n6\n", "--trigger-source Software --strobe-line Line1");
  EXPECT_NE(log.find("lines Line0, Line1; triggered by "), std::string::npos) << log;
  EXPECT_NE(log.find("pulse Software, and check its wire"), std::string::npos) << log;
  EXPECT_EQ(line.read_feature(1), 0U) << "the line was set back";
  const std::string unknown = menu.type("2\n4\n6\n", "--strobe-line Line7");
  EXPECT_NE(unknown.find("Line7"), std::string::npos) << unknown;
  std::filesystem::remove(file);
}

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
