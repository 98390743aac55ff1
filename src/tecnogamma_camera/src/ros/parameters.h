// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "acquisition/acquisition.h"
#include "open_camera.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

struct Parameters {
  std::string camera;
  std::string frame_id = "camera_optical_frame";
  std::string scanner_model;
  std::string detector = "fir_derivative";
  DetectorSettings detection;
  int live_ratio = 10;
  CameraOptions source;
  std::string bag_topic;
  AcquisitionParameters acquisition;
};

/// With range, unit and meaning of each.
void describe(scan_cell_common::ParameterTable& table, Parameters& parameters);

}  // namespace tecnogamma_camera
