// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "aravis/line_camera.h"
#include "aravis/opened_camera.h"

using fake_cameras::genicam_file;
using fake_cameras::grab;
using fake_cameras::LineCamera;
using fake_cameras::open;
using fake_cameras::Program;
using fake_cameras::refused_parameter;
using fake_cameras::small_region;
using scan_cell_common::Refused;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::MissingFeature;
using tecnogamma_camera::Trigger;

TEST(AravisCamera, TakesParametersOnlyInStopButForTheExposure) {
  const Program program;
  const auto camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kFreeRun);
  EXPECT_THROW(camera->configure(small_region(20)), Refused);
  EXPECT_THROW(camera->start(Trigger::kFreeRun), Refused);
  camera->set_exposure(0.004);
  EXPECT_DOUBLE_EQ(camera->describe().exposure, 0.004);
  camera->stop();
  camera->configure(small_region(20));
}

TEST(AravisCamera, NamesTheParameterThatItDoesNotTake) {
  const Program program;
  const auto camera = open();
  CameraSettings settings;
  settings.region = {2000, 0, 100, 100};
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "region");
  settings = {};
  settings.exposure = 20.0;
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "exposure");
  settings = {};
  settings.rate = 5000.0;
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "rate");
  settings = {};
  settings.gain = 100.0;
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "gain");
  settings = {};
  settings.trigger_source = "Line9";
  camera->configure(settings);
  EXPECT_THROW(camera->start(Trigger::kExternal), scan_cell_common::Error);
}

TEST(AravisCamera, KeepsItsRegionWhereAnotherIsRefused) {
  const std::string file = genicam_file();
  LineCamera::save_genicam_with_steps(file);
  LineCamera line(file);
  const auto camera = open();
  camera->configure(small_region(50));
  CameraSettings settings = small_region(50);
  settings.region.width = 250;  // the camera takes 240
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "region");
  camera->start(Trigger::kFreeRun);
  const auto frame = grab(*camera);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->packets_lost, 0U) << "the frame must be of the region that was kept";
  EXPECT_EQ(frame->image.columns, 256);
  std::filesystem::remove(file);
}

TEST(AravisCamera, NamesThePixelFormatThatItDoesNotHave) {
  LineCamera line;
  const auto camera = open();
  CameraSettings settings = small_region(50);
  settings.pixel_format = "Mono10";
  try {
    camera->configure(settings);
    FAIL();
  } catch (const MissingFeature& error) {
    EXPECT_EQ(error.value(), "PixelFormat Mono10");
  }
  settings.pixel_format = "RGB8";  // it has that, but there are no grey values in it
  EXPECT_EQ(refused_parameter([&] { camera->configure(settings); }), "pixel_format");
}

TEST(AravisCamera, KeepsTheRateOfFreeRunAfterAnExternalTrigger) {
  const std::string file = genicam_file();
  LineCamera::save_genicam_with_rate_enable(file);
  LineCamera line(file);
  const auto camera = open();
  camera->configure(small_region(50));
  camera->start(Trigger::kExternal);
  EXPECT_FALSE(line.rate_is_enabled());
  camera->stop();
  camera->start(Trigger::kFreeRun);
  EXPECT_TRUE(line.rate_is_enabled());
  std::filesystem::remove(file);
}

TEST(AravisCamera, NamesTheFeatureThatItDoesNotHave) {
  const std::string file = genicam_file();
  LineCamera::save_genicam_without("TriggerSource", file);
  {
    LineCamera line(file);
    const auto camera = open();
    camera->configure(small_region(50));
    try {
      camera->start(Trigger::kExternal);
      FAIL();
    } catch (const MissingFeature& error) {
      EXPECT_EQ(error.value(), "TriggerSource");
    }
    camera->start(Trigger::kFreeRun);  // what it has still works
    EXPECT_TRUE(grab(*camera));
  }
  std::filesystem::remove(file);
}

TEST(AravisCamera, DrivesTheStrobeWhileItRunsAndSetsTheLineBack) {
  const std::string file = genicam_file();
  LineCamera::Features()
      .words("LineSelector", {"Line0", "Line1"})
      .words("LineMode", {"Input", "Output"})
      .words("LineSource", {"Off", "UserOutput0", "ExposureActive"})
      .save(file);
  LineCamera line(file);
  line.write_feature(2, 1);
  const auto camera = open();
  CameraSettings settings = small_region(50);
  settings.strobe_line = "Line1";
  camera->configure(settings);
  EXPECT_EQ(line.read_feature(1), 0U) << "nothing is driven in STOP";
  for (const Trigger trigger : {Trigger::kExternal, Trigger::kFreeRun}) {
    camera->start(trigger);
    EXPECT_EQ(line.read_feature(0), 1U);
    EXPECT_EQ(line.read_feature(1), 1U);
    EXPECT_EQ(line.read_feature(2), 2U);
    camera->stop();
    for (unsigned i = 0; i < 3; ++i)
      EXPECT_EQ(line.read_feature(i), i == 2 ? 1U : 0U) << "as it was before";
  }
  settings.strobe_source = "Moonlight";
  camera->configure(settings);
  EXPECT_THROW(camera->start(Trigger::kFreeRun), scan_cell_common::Error);
  for (unsigned i = 0; i < 3; ++i)
    EXPECT_EQ(line.read_feature(i), i == 2 ? 1U : 0U) << "also where the start fails";
  std::filesystem::remove(file);
}

TEST(AravisCamera, DrivesFourStrobesAtOnceAndListsItsInputs) {
  const std::string file = genicam_file();
  constexpr unsigned kLines = 8, kMode = 1, kSource = kMode + kLines;  // registers
  const std::vector<std::string> lines = {"In0",  "In1",  "In2",  "In3",
                                          "Out0", "Out1", "Out2", "Out3"};
  LineCamera::Features()
      .words("LineSelector", lines)
      .words_of_each("LineSelector", "LineMode", {"Input", "Output"}, kLines)
      .words_of_each("LineSelector", "LineSource", {"Off", "ExposureActive"}, kLines)
      .save(file);
  LineCamera line(file);
  line.write_feature(0, 2);  // In2 is selected
  const auto camera = open();
  EXPECT_EQ(camera->describe().lines, lines);
  CameraSettings settings = small_region(50);
  settings.strobe_line = " Out0 , Out1,Out2,\tOut3 ";
  camera->configure(settings);
  camera->start(Trigger::kExternal);
  for (unsigned i = 0; i < kLines; ++i) {
    EXPECT_EQ(line.read_feature(kMode + i), i < 4 ? 0U : 1U) << lines[i];
    EXPECT_EQ(line.read_feature(kSource + i), i < 4 ? 0U : 1U) << lines[i];
  }
  camera->stop();
  for (unsigned i = 0; i < kLines; ++i) {
    EXPECT_EQ(line.read_feature(kMode + i), 0U) << lines[i] << " as it was before";
    EXPECT_EQ(line.read_feature(kSource + i), 0U) << lines[i] << " as it was before";
  }
  EXPECT_EQ(line.read_feature(0), 2U) << "the selector, too";
  settings.strobe_line = "Out0, Out7";
  camera->configure(settings);
  EXPECT_THROW(camera->start(Trigger::kFreeRun), scan_cell_common::Error);
  EXPECT_EQ(line.read_feature(kMode + 4), 0U) << "none is driven where one is not there";
  std::filesystem::remove(file);
}

TEST(AravisCamera, NeedsLinesOnlyWhereAStrobeIsAskedFor) {
  const Program program;
  const auto camera = open();
  CameraSettings settings = small_region(50);
  settings.strobe_line = "Line1";
  camera->configure(settings);
  try {
    camera->start(Trigger::kFreeRun);
    FAIL();
  } catch (const MissingFeature& error) {
    EXPECT_EQ(error.value(), "LineSelector");
  }
  camera->configure(small_region(50));
  camera->start(Trigger::kFreeRun);
  EXPECT_TRUE(grab(*camera));
}
