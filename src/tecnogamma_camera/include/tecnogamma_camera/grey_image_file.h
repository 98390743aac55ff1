// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "tecnogamma_camera/image_view.h"

namespace tecnogamma_camera {

/// Loads an image of 8 or 16 bit grey pixels. A colour image whose channels are all equal becomes
/// grey.
/// @throw scan_cell_common::FileError if it is missing, not an image, or truncated
/// @throw scan_cell_common::UnusableInput if its pixels are of another kind
cv::Mat load_grey_image(const std::string& path);

/// A view of an image of 8 or 16 bit grey pixels. The image must outlive the view.
GreyImage grey_view(const cv::Mat& image);

}  // namespace tecnogamma_camera
