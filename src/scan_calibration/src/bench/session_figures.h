// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace scan_calibration {

/// Real images: a session of a robot and a laser, and OpenCV's pictures of a checkerboard.
void print_real_sessions();

/// Corners in rendered images, beside OpenCV's.
void print_corner_accuracy();

/// Time for the images of 70 views of 1696 x 1710 pixels with two laser lines.
void print_reading_time();

}  // namespace scan_calibration
