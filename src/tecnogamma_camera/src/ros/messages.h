// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/CameraSettings.h>
#include <scan_cell_msgs/FrameInfo.h>
#include <scan_cell_msgs/PeakProfile.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <string>

#include "acquisition/acquisition.h"
#include "parameters.h"
#include "scan_cell_common/scanner/scanner_model.h"
#include "tecnogamma_camera/peak_profile.h"

namespace tecnogamma_camera {

/// Moves the arrays out of `profile`.
scan_cell_msgs::PeakProfilePtr to_message(const NumberedFrame& frame, const std::string& frame_id,
                                          PeakProfile&& profile);

/// @pre the frame is complete
sensor_msgs::ImagePtr to_image_message(const NumberedFrame& frame, const std::string& frame_id);

/// The frame's number, and what else the image's header cannot carry.
scan_cell_msgs::FrameInfoPtr to_frame_info(const NumberedFrame& frame, const std::string& frame_id);

/// Exposure, region, gain and rate.
/// @throw scan_cell_common::InvalidParameter naming the field that is out of range
CameraChange from_message(const scan_cell_msgs::CameraSettings& settings);

/// `tuning` with the detector, choice and live ratio of `settings`, where they are given.
/// @throw scan_cell_common::InvalidParameter naming the field that is out of range
Tuning changed(const Tuning& tuning, const scan_cell_msgs::CameraSettings& settings);

/// @param exposure [s]
scan_cell_msgs::CameraSettings to_message(double exposure, const Region& region);

/// The settings that were asked for, so that they can be given back.
scan_cell_msgs::CameraSettings to_message(const CameraSettings& settings, const Tuning& tuning);

/// Sets where on the sensor the frame's image lies.
void set_region(const NumberedFrame& frame, sensor_msgs::CameraInfo& info);

/// Why a scanner model does not fit this camera; empty if it does.
std::string find_fault(const scan_cell_common::ScannerModel& model,
                       const CameraDescription& camera);

/// The camera info, which does not change from frame to frame: intrinsics if there is a model
/// without a fault (else zeros, which means uncalibrated), sensor size and region of interest.
sensor_msgs::CameraInfo to_camera_info(const CameraDescription& camera,
                                       const scan_cell_common::ScannerModel* model,
                                       const std::string& frame_id);

}  // namespace tecnogamma_camera
