// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "tecnogamma_camera/acquisition.h"
#include "tecnogamma_camera/open_camera.h"
#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {

/// The node's private parameters (docs/tecnogamma_camera.md).
struct Parameters {
  std::string camera;  //!< id, serial number, address, folder:PATH or bag:PATH; empty: the only one
  std::string frame_id = "camera_optical_frame";
  std::string scanner_model;  //!< path, for camera_info; empty: uncalibrated
  std::string detector = "fir_derivative";
  DetectorSettings detection;
  int live_ratio = 10;  //!< profiles to an image in RELIEF_LIVE
  CameraOptions source;
  std::string bag_topic;  //!< of the images; empty: the only one
  AcquisitionParameters acquisition;

  /// @throw scan_cell_common::InvalidParameter naming the bad, missing or unknown parameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace tecnogamma_camera
