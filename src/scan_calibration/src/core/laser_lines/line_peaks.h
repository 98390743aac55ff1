// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "tecnogamma_camera/peak_profile.h"

namespace scan_calibration {

/// A peak that may be the laser's.
struct LinePeak {
  Eigen::Vector2d pixel;
  double width;  //!< [px] of the stripe, in the direction in which it was crossed
};

/// Peaks that may be the laser's, from one way of going through the image.
struct LinePeaks {
  bool along_columns = true;  //!< the line runs from top to bottom: crossed along x
  std::vector<LinePeak> peaks;
};

/// The peaks of a profile, whose line runs from top to bottom.
LinePeaks line_peaks(const tecnogamma_camera::PeakProfile& profile);

/// All peaks that may be the laser's, searched once for a line from top to bottom and once for one
/// from side to side. Several per row are kept, so that the line is not lost where a reflection
/// outshines it.
/// @param detector of tecnogamma_camera
/// @throw scan_cell_common::InvalidParameter if there is no such detector
std::vector<LinePeaks> line_peaks(const cv::Mat& image, const std::string& detector);

}  // namespace scan_calibration
