// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "aravis/line_camera.h"
#include "aravis/opened_camera.h"
#include "open_camera.h"
#include "payload/payloads.h"
#include "tecnogamma_camera/peak_detector.h"

using fake_cameras::genicam_file;
using fake_cameras::grab;
using fake_cameras::kAddress;
using fake_cameras::LineCamera;
using fake_cameras::open;
using fake_cameras::Program;
using fake_cameras::refused_parameter;
using fake_cameras::small_region;
using scan_cell_common::ConnectionError;
using scan_cell_common::Refused;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::CounterStep;
using tecnogamma_camera::Trigger;

TEST(AravisCamera, IsListedAndOpenedByItsIdSerialNumberOrAddress) {
  const Program program({"-s", "SERIAL7"});
  open();
  const auto cameras = tecnogamma_camera::list_aravis_cameras();
  ASSERT_EQ(cameras.size(), 1U);
  EXPECT_EQ(cameras[0].serial, "SERIAL7");
  EXPECT_EQ(cameras[0].address, kAddress);
  for (const std::string& name : {cameras[0].id, std::string("SERIAL7"), std::string()}) {
    const auto description = open(name)->describe();
    EXPECT_EQ(description.serial, "SERIAL7");
    EXPECT_EQ(description.transport, "GigE Vision");
    EXPECT_EQ(description.sensor_columns, 2048);
    EXPECT_EQ(description.sensor_rows, 2048);
  }
}

TEST(AravisCamera, SaysWhichCamerasAnswerWhereTheNamedOneDoesNot) {
  const Program program;
  open();
  try {
    tecnogamma_camera::open_aravis_camera("NOT-THERE", {});
    FAIL();
  } catch (const ConnectionError& error) {
    EXPECT_NE(std::string(error.what()).find("NOT-THERE"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("GV01"), std::string::npos);
  }
  EXPECT_THROW(tecnogamma_camera::open_aravis_camera("127.0.0.9", {}), ConnectionError);
}

TEST(AravisCamera, SaysThatAnotherProgramHoldsIt) {
  const Program program;
  const auto holder = open();
  EXPECT_THROW(tecnogamma_camera::open_aravis_camera(kAddress, {}), ConnectionError);
}

TEST(AravisCamera, StreamsEveryFrameAcrossTheTurnOfItsCounter) {
  const Program program;
  const auto camera = open();
  camera->configure(small_region(200));
  tecnogamma_camera::CounterUnwrapper unwrapper(camera->describe().counter);
  camera->start(Trigger::kFreeRun);
  constexpr int kFrames = 300;  // the counter of the fake camera starts at 65400
  std::uint64_t lost = 0;
  for (int i = 0; i < kFrames; ++i) {
    const auto frame = grab(*camera);
    ASSERT_TRUE(frame);
    const CounterStep step = unwrapper.unwrap(frame->counter);
    using Kind = CounterStep::Kind;
    ASSERT_TRUE(step.kind == Kind::kNext || step.kind == Kind::kGap || i == 0);
    lost += step.lost;
    if (frame->packets_lost > 0) continue;
    EXPECT_EQ(frame->image.columns, 256);
    EXPECT_EQ(frame->image.rows, 64);
    EXPECT_EQ(frame->image.first_column, 64);
    EXPECT_EQ(frame->image.first_row, 32);
    EXPECT_GT(frame->device_time, 0);
    EXPECT_GE(frame->host_time, frame->device_time);  // the fake camera keeps the host's time
  }
  EXPECT_EQ(lost, camera->statistics().underruns);
  EXPECT_GE(camera->statistics().completed + camera->statistics().failures, kFrames);
  camera->stop();
  EXPECT_THROW(grab(*camera), Refused);
}

TEST(AravisCamera, ShowsWhatIsInFrontOfIt) {
  LineCamera line;
  const auto camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kFreeRun);
  const auto frame = grab(*camera);
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->packets_lost, 0U);
  tecnogamma_camera::PeakProfile profile;
  tecnogamma_camera::make_detector("fir_derivative", {})->detect(frame->image, profile);
  ASSERT_EQ(profile.rows(), 64);
  for (int row = 0; row < profile.rows(); ++row)
    EXPECT_NEAR(profile.position[row], LineCamera::line(profile.first_row + row), 0.02);
}

TEST(AravisCamera, ExposesOneFrameAPulse) {
  const Program program;
  const auto camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kExternal);
  EXPECT_FALSE(camera->grab(std::chrono::milliseconds(300)));
  std::uint64_t counter = 0;
  for (int i = 0; i < 5; ++i) {
    camera->software_trigger();
    const auto frame = grab(*camera);
    ASSERT_TRUE(frame);
    EXPECT_TRUE(i == 0 || frame->counter == counter + 1);
    counter = frame->counter;
    EXPECT_FALSE(camera->grab(std::chrono::milliseconds(100)));
  }
  camera->stop();
  camera->start(Trigger::kFreeRun);  // and back
  EXPECT_TRUE(grab(*camera));
}

TEST(AravisCamera, HandsOutGreyValuesOfMoreThanEightBitsPackedOrNot) {
  const std::string file = genicam_file();
  LineCamera::save_genicam_with_mono12p(file);
  LineCamera line(file);
  const auto camera = open();
  for (const auto& [format, bits] : {std::pair{"Mono16", 16}, {"Mono12p", 12}, {"Mono8", 8}}) {
    CameraSettings settings = small_region(50);
    settings.pixel_format = format;
    camera->configure(settings);
    EXPECT_EQ(camera->describe().grey_bits, bits);
    camera->start(Trigger::kFreeRun);
    const auto frame = grab(*camera);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->image.bits, bits);
    tecnogamma_camera::PeakProfile profile;
    tecnogamma_camera::make_detector("fir_derivative", {})->detect(frame->image, profile);
    for (int row = 0; row < profile.rows(); ++row) {
      const double centre = LineCamera::line(profile.first_row + row);
      const double light = 10 + 200 * stripes::gaussian_pixel(std::lround(centre), centre, 1.5);
      EXPECT_NEAR(profile.position[row], centre, 0.02) << format;
      EXPECT_NEAR(profile.intensity[row], bits == 8 ? light : 16 * light, 1) << format;
    }
    camera->stop();
  }
  std::filesystem::remove(file);
}

TEST(AravisCamera, ThatSends3D03FramesGivesItsPeaksNumbersAndTimes) {
  const std::string file = genicam_file();
  LineCamera::Features()
      .number("HeightInterface")
      .number("Peak0_3DY")
      .number("Peak0_3DH")
      .save(file);
  std::uint32_t counter = 0xFFFFF0;
  LineCamera smart(file, [&counter](std::uint8_t* bytes, int columns, int rows) {
    payloads::Photonfocus sent(columns, rows / 5);
    for (int block = 0; block < rows / 5; ++block) {
      sent.number(block, counter & 0xFFFFFF, 100 * counter);
      ++counter;
      for (int column = 0; column < columns; ++column)
        sent.set(block, column, 14, 176, 10, 128);
    }
    std::copy(sent.bytes.begin(), sent.bytes.end(), bytes);
  });
  smart.write_feature(0, 10);  // two frames combined
  smart.write_feature(1, 300);
  smart.write_feature(2, 400);
  open();
  tecnogamma_camera::CameraOptions options;
  options.payload.format = "photonfocus_3d03";
  const auto camera = tecnogamma_camera::open_camera(kAddress, options);
  CameraSettings settings;
  settings.region = {64, 0, 256, 0};
  settings.rate = 50;
  camera->configure(settings);
  tecnogamma_camera::CounterUnwrapper unwrapper(camera->describe().counter);
  camera->start(Trigger::kFreeRun);
  scan_cell_common::Nanoseconds last = 0;
  for (int i = 0; i < 30; ++i) {
    const auto frame = grab(*camera);
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->fault, "");
    if (frame->packets_lost > 0) continue;
    const CounterStep step = unwrapper.unwrap(frame->counter);
    ASSERT_TRUE(step.kind == CounterStep::Kind::kNext || step.kind == CounterStep::Kind::kGap ||
                i == 0);
    ASSERT_NE(frame->peaks, nullptr);
    EXPECT_EQ(frame->peaks->rows(), 256);
    EXPECT_EQ(frame->peaks->first_row, 2048 - 64 - 256);
    EXPECT_EQ(frame->peaks->position[0], 300 + 58.75);
    if (step.kind == CounterStep::Kind::kNext) {
      EXPECT_EQ(frame->device_time - last, 100000);
    }
    last = frame->device_time;
  }
  settings.region = {64, 10, 256, 0};
  camera->stop();
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "region");
  std::filesystem::remove(file);
}

TEST(AravisCamera, NeverHandsOutPixelsOfAFrameWithPacketsMissing) {
  const Program program({"-r", "50"});  // of a thousand packets
  const auto camera = open();
  CameraSettings settings;
  settings.region = {0, 0, 512, 32};
  settings.rate = 100;
  camera->configure(settings);
  camera->start(Trigger::kFreeRun);
  int whole = 0, incomplete = 0, without_number = 0;
  tecnogamma_camera::CounterUnwrapper unwrapper(camera->describe().counter);
  EXPECT_TRUE(fake_cameras::wait_until([&] {
    const auto frame = grab(*camera);
    if (!frame) return false;
    const CounterStep::Kind step = unwrapper.unwrap(frame->counter).kind;
    EXPECT_NE(step, CounterStep::Kind::kBackward) << "the number of an earlier frame";
    EXPECT_NE(step, CounterStep::Kind::kRepeated) << "the number of an earlier frame";
    if (frame->packets_lost > 0) {
      ++incomplete;
      EXPECT_EQ(frame->image.pixels, nullptr);
      EXPECT_EQ(frame->image.rows, 32);
      without_number += step == CounterStep::Kind::kInvalid ? 1 : 0;
    } else {
      ++whole;
    }
    return whole >= 5 && incomplete >= 5 && without_number >= 1;
  }));
}

TEST(AravisCamera, IsFoundAgainAfterItWasLost) {
  auto program = std::make_unique<Program>();
  auto camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kFreeRun);
  ASSERT_TRUE(grab(*camera));
  program.reset();
  EXPECT_TRUE(fake_cameras::wait_until([&] {
    try {
      camera->grab(std::chrono::milliseconds(100));
      return false;
    } catch (const ConnectionError&) {
      return true;
    }
  }));
  camera.reset();
  program = std::make_unique<Program>();
  camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kFreeRun);
  EXPECT_TRUE(grab(*camera));
}
