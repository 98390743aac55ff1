// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "tecnogamma_camera/image_view.h"

namespace tecnogamma_camera {

/// An image of 8 or 16 bit grey pixels. Grey that was saved as colour, its channels all the same,
/// becomes grey.
/// @throw scan_cell_common::FileError if it is missing, not an image, or truncated
/// @throw scan_cell_common::UnusableInput if its pixels are of another kind
cv::Mat load_grey_image(const std::string& path);

/// The view of an image of 8 or 16 bit grey pixels, which must outlive it.
GreyImage grey_view(const cv::Mat& image);

}  // namespace tecnogamma_camera
