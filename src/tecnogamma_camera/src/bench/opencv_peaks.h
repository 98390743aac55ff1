// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace tecnogamma_camera {

/// Peaks as they are usually found with OpenCV, row by row, at a trigger level of 60: with the
/// function for each of detector_names(). NaN in the rows without a peak.
/// @throw std::out_of_range for another name
void detect_with_opencv(const std::string& detector, const cv::Mat& image,
                        std::vector<float>& positions);

}  // namespace tecnogamma_camera
