// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace scan_calibration {

constexpr double kMaxFitRadius = 20;  //!< [px] about a corner that its fit looks at; chosen
constexpr double kFitShare = 0.55;    //!< of the way to the next edge, chosen: its blur stays out

/// A corner where four squares meet, known to a pixel or so.
struct RoughCorner {
  Eigen::Vector2d pixel;
  Eigen::Vector2d along_columns;  //!< [px] to the next corner of its row, or from the previous one
  Eigen::Vector2d along_rows;     //!< [px] the same along its column
};

/// Finds the corner by fitting the image of four squares to the grey values around it,
///
///     I(p) = mean + gradient . p + contrast * erf(d1 / blur) * erf(d2 / blur)
///
/// where d1, d2 are the distances from two straight edges through the corner: least squares, which
/// is the maximum likelihood estimate in white noise (Levenberg-Marquardt, ceres::TinySolver).
/// @param image CV_32F
/// @param rough the corner; its pixel is moved
/// @return false, with nothing moved, if the grey values look different: the corner is covered, cut
/// off by the image's border or too faint
bool refine_corner(const cv::Mat& image, RoughCorner& rough);

}  // namespace scan_calibration
