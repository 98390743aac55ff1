// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "acquisition/acquisition.h"
#include "open_camera.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// What the node itself does with frames. It can be changed while frames come.
struct Tuning {
  std::string detector = "fir_derivative";
  DetectorSettings detection;
  int live_ratio = 10;
};

constexpr int kMaxLiveRatio = 100000;  //!< profiles to an image; chosen

struct Parameters {
  std::string camera;
  std::string frame_id = "camera_optical_frame";
  std::string scanner_model;
  Tuning tuning;
  CameraOptions source;
  std::string bag_topic;
  AcquisitionParameters acquisition;
};

/// Describes each parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace tecnogamma_camera
