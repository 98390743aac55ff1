// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "aravis/aravis_camera.h"
#include "aravis/fake_cameras.h"

/// What the tests of cameras on 127.0.0.1 have in common.
namespace fake_cameras {

using scan_cell_common::ConnectionError;
using tecnogamma_camera::Camera;
using tecnogamma_camera::CameraSettings;
using tecnogamma_camera::Frame;

/// Opens the camera as soon as it answers.
inline std::unique_ptr<Camera> open(const std::string& name = kAddress) {
  std::unique_ptr<Camera> camera;
  std::string reason;
  wait_until([&] {
    try {
      camera = tecnogamma_camera::open_aravis_camera(name, {});
    } catch (const ConnectionError& error) {
      reason = error.what();
    }
    return camera != nullptr;
  });
  EXPECT_NE(camera, nullptr) << reason;
  return camera;
}

inline CameraSettings small_region(double rate) {
  CameraSettings settings;
  settings.region = {64, 32, 256, 64};
  settings.rate = rate;
  settings.trigger_source = "Software";
  return settings;
}

inline std::optional<Frame> grab(Camera& camera) {
  return camera.grab(std::chrono::seconds(10));
}

/// A path for the description of a fake camera.
inline std::string genicam_file() {
  return (std::filesystem::temp_directory_path() / ("fake_" + std::to_string(getpid()) + ".xml"))
      .string();
}

/// The name of the refused parameter.
template <class Act>
std::string refused_parameter(const Act& act) {
  try {
    act();
  } catch (const scan_cell_common::InvalidParameter& error) {
    return error.thing();
  }
  return "nothing";
}

}  // namespace fake_cameras
