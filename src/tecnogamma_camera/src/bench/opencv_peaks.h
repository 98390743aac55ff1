// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace tecnogamma_camera {

/// Peaks as OpenCV is usually used to find them, row by row. The functions, by detector_names():
/// threshold and boundingRect; minMaxLoc, and dot over a window of 15 columns; filter2D and
/// minMaxLoc. An automatic level adds meanStdDev. Rows without a peak are NaN.
/// @param trigger_level as in DetectorSettings
/// @throw std::out_of_range for another name
void detect_with_opencv(const std::string& detector, int trigger_level, const cv::Mat& image,
                        std::vector<float>& positions);

}  // namespace tecnogamma_camera
