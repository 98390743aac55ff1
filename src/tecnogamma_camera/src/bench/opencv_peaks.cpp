// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "opencv_peaks.h"

#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "tecnogamma_camera/peak_detector.h"

namespace tecnogamma_camera {
namespace {

constexpr int kHalfWindow = 7;  // [px] chosen

/// The usual automatic level, from mean and scatter of the row.
double level_of(const cv::Mat& row, int trigger_level) {
  if (trigger_level != kAutomaticLevel) return trigger_level;
  cv::Scalar mean, deviation;
  cv::meanStdDev(row, mean, deviation);
  constexpr double kDeviations = 4;  // chosen
  return mean[0] + kDeviations * deviation[0];
}

/// Threshold, and the middle of the box around all lit pixels. It cannot separate spots: OpenCV's
/// functions for that take many times longer.
float threshold_row(const cv::Mat& row, double level) {
  cv::Mat lit;
  cv::threshold(row, lit, level, 255, cv::THRESH_BINARY);
  const cv::Rect box = cv::boundingRect(lit);
  if (box.width == 0) return NAN;
  return static_cast<float>(box.x) + 0.5F * static_cast<float>(box.width - 1);
}

/// Brightest pixel, and the centre of gravity about it.
float center_of_gravity_of_row(const cv::Mat& row, double level) {
  double most = 0;
  cv::Point place;
  cv::minMaxLoc(row, nullptr, &most, nullptr, &place);
  if (most <= level || place.x < kHalfWindow || place.x + kHalfWindow >= row.cols) return NAN;
  const cv::Range window(place.x - kHalfWindow, place.x + kHalfWindow + 1);
  cv::Mat light;
  row.colRange(window).convertTo(light, CV_32F);
  light -= 0.5 * (light.at<float>(0) + light.at<float>(2 * kHalfWindow));
  cv::Mat columns(1, window.size(), CV_32F);
  std::iota(columns.begin<float>(), columns.end<float>(), static_cast<float>(window.start));
  return static_cast<float>(light.dot(columns) / cv::sum(light)[0]);
}

/// Derivative of the smoothed row, and its zero between maximum and minimum.
float fir_derivative_of_row(const cv::Mat& row, double level) {
  static const cv::Mat kernel = [] {
    constexpr int kReach = 5;                 // [px] chosen
    constexpr float kVariance = 1.5F * 1.5F;  // [px^2] of the line in the bench's image
    cv::Mat taps(1, 2 * kReach + 1, CV_32F);
    for (int i = -kReach; i <= kReach; ++i) {
      const auto offset = static_cast<float>(i);
      taps.at<float>(i + kReach) = offset * std::exp(-0.5F * offset * offset / kVariance);
    }
    return taps;
  }();
  cv::Mat derivative;
  cv::filter2D(row, derivative, CV_32F, kernel);
  cv::Point left, right;
  double most = 0;
  cv::minMaxLoc(derivative, nullptr, &most, &right, &left);
  if (most <= level) return NAN;
  for (int column = left.x; column < right.x; ++column) {
    const float before = derivative.at<float>(column), after = derivative.at<float>(column + 1);
    if (before > 0 && after <= 0) return static_cast<float>(column) + before / (before - after);
  }
  return NAN;
}

}  // namespace

void detect_with_opencv(const std::string& detector, int trigger_level, const cv::Mat& image,
                        std::vector<float>& positions) {
  static const std::map<std::string, std::function<float(const cv::Mat&, double)>> kWays = {
      {"threshold", threshold_row},
      {"center_of_gravity", center_of_gravity_of_row},
      {"fir_derivative", fir_derivative_of_row}};
  const auto& way = kWays.at(detector);
  positions.resize(static_cast<std::size_t>(image.rows));
  for (int row = 0; row < image.rows; ++row) {
    const cv::Mat pixels = image.row(row);
    positions[static_cast<std::size_t>(row)] = way(pixels, level_of(pixels, trigger_level));
  }
}

}  // namespace tecnogamma_camera
