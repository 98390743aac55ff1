// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "tecnogamma_camera/peak_detector.h"

namespace {

using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::ImageView8;
using tecnogamma_camera::PeakProfile;

/// A slanting line of 1.5 px, 200 grey values high, on a background of 12 with noise of 3.
cv::Mat line_image(int columns, int rows) {
  cv::Mat light(rows, columns, CV_32F);
  std::mt19937 engine(1);
  std::normal_distribution<float> noise(12, 3);
  for (int row = 0; row < rows; ++row) {
    const double centre = 0.3 * columns + 0.2 * row + 20 * std::sin(row * 0.01);
    for (int column = 0; column < columns; ++column) {
      const double offset = (column - centre) / 1.5;
      light.at<float>(row, column) =
          noise(engine) + static_cast<float>(200 * std::exp(-0.5 * offset * offset));
    }
  }
  cv::Mat image;
  light.convertTo(image, CV_8U);
  return image;
}

/// Median time of a call [s].
double median_time(const std::function<void()>& call) {
  constexpr int kCalls = 101;
  std::vector<double> times;
  for (int i = 0; i < kCalls; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    times.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + kCalls / 2, times.end());
  return times[kCalls / 2];
}

std::uint32_t sum_of_bytes(const cv::Mat& image) {
  return std::accumulate(image.datastart, image.dataend, 0U);
}

/// The centre of gravity as it is usually written with OpenCV, row by row.
void detect_with_opencv(const cv::Mat& image, const DetectorSettings& settings,
                        std::vector<float>& positions) {
  const int half = settings.window / 2;
  positions.assign(image.rows, NAN);
  cv::Mat columns(1, image.cols, CV_32F);
  std::iota(columns.begin<float>(), columns.end<float>(), 0.0F);
  for (int row = 0; row < image.rows; ++row) {
    double most = 0;
    cv::Point place;
    cv::minMaxLoc(image.row(row), nullptr, &most, nullptr, &place);
    if (most <= settings.trigger_level || place.x < half || place.x + half >= image.cols) continue;
    const cv::Range window(place.x - half, place.x + half + 1);
    cv::Mat light;
    image.row(row).colRange(window).convertTo(light, CV_32F);
    light -= 0.5 * (light.at<float>(0) + light.at<float>(2 * half));
    positions[row] = static_cast<float>(light.dot(columns.colRange(window)) / cv::sum(light)[0]);
  }
}

void print(const char* what, double seconds, double yardstick, const char* yardstick_name) {
  std::printf("%-48s %8.1f us   %-24s %8.1f us   ratio %6.2f\n", what, seconds * 1e6,
              yardstick_name, yardstick * 1e6, seconds / yardstick);
}

void bench(int columns, int rows) {
  const cv::Mat image = line_image(columns, rows);
  ImageView8 view;
  view.pixels = image.data;
  view.columns = columns;
  view.rows = rows;
  view.stride = columns;
  const DetectorSettings settings;
  volatile std::uint32_t sink = 0;
  const double pass = median_time([&] { sink = sum_of_bytes(image); });
  std::vector<float> positions;
  const double opencv = median_time([&] { detect_with_opencv(image, settings, positions); });
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    const auto detector = tecnogamma_camera::make_detector(name, settings);
    PeakProfile profile;
    const double time = median_time([&] { detector->detect(view, profile); });
    const std::string what =
        name + " " + std::to_string(columns) + " x " + std::to_string(rows) + ", 8 bit";
    print(what.c_str(), time, pass, "one pass over its bytes");
    print(what.c_str(), time, opencv, "OpenCV, row by row");
  }
}

}  // namespace

int main() {
  cv::setNumThreads(1);
  bench(1024, 512);
  bench(1696, 1710);
}
