// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "../src/ros/diagnostics.h"
#include "../src/ros/messages.h"

using diagnostic_msgs::DiagnosticStatus;
using scan_cell_common::ScannerModel;
using tecnogamma_camera::AcquisitionState;
using tecnogamma_camera::CameraDescription;

namespace {

ScannerModel scanner(int columns, int rows) {
  ScannerModel model;
  model.camera.width = columns;
  model.camera.height = rows;
  model.camera.fx = model.camera.fy = 901.5;
  return model;
}

CameraDescription camera() {
  CameraDescription description;
  description.sensor_columns = 2048;
  description.sensor_rows = 1088;
  return description;
}

}  // namespace

TEST(CameraInfo, TellsTheLensOfTheScannerModel) {
  const ScannerModel model = scanner(2048, 1088);
  EXPECT_EQ(find_fault(model, camera()), "");
  EXPECT_EQ(tecnogamma_camera::to_camera_info(camera(), &model, "camera").K[0], 901.5);
}

TEST(CameraInfo, IsUncalibratedWhereTheScannerModelIsOfAnotherSensor) {
  const ScannerModel model = scanner(1696, 1710);
  const auto info = tecnogamma_camera::to_camera_info(camera(), &model, "camera");
  EXPECT_EQ(info.width, 2048U);
  EXPECT_EQ(info.K[0], 0) << "zero means: not calibrated";
  EXPECT_EQ(info.P[0], 0);
  EXPECT_TRUE(info.D.empty());
}

TEST(ImageMessage, IsMono16OfTheCamerasOwnGreyValuesAboveEightBits) {
  const std::uint16_t pixels[] = {0, 1, 4095, 999, 0x0102, 3, 4, 999};
  tecnogamma_camera::Frame frame;
  frame.image = {tecnogamma_camera::ImageView16{pixels, 3, 2, 4, 10, 20}, 12};
  const auto message = tecnogamma_camera::to_image_message(
      {tecnogamma_camera::AcquisitionMode::kLiveOnly, 1, 5, 1000, frame, camera()}, "camera");
  EXPECT_EQ(message->encoding, "mono16");
  EXPECT_EQ(message->width, 3U);
  EXPECT_EQ(message->height, 2U);
  EXPECT_EQ(message->step, 6U);
  EXPECT_EQ(message->is_bigendian, 0);
  EXPECT_EQ(message->data, (std::vector<std::uint8_t>{0, 0, 1, 0, 0xFF, 0x0F, 2, 1, 3, 0, 4, 0}));
}

TEST(Diagnostics, AreAnErrorWhereTheScannerModelIsOfAnotherSensor) {
  AcquisitionState state;
  state.connected = true;
  diagnostic_updater::DiagnosticStatusWrapper status;
  write_diagnostics(state, state, "", status);
  EXPECT_EQ(status.level, DiagnosticStatus::OK);
  write_diagnostics(state, state, find_fault(scanner(1696, 1710), camera()), status);
  EXPECT_EQ(status.level, DiagnosticStatus::ERROR);
  EXPECT_NE(status.message.find("1696 x 1710"), std::string::npos) << status.message;
  EXPECT_NE(status.message.find("2048 x 1088"), std::string::npos) << status.message;
}
