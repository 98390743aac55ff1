// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "opencv_peaks.h"
#include "peak_accuracy.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tecnogamma_camera/peak_detector.h"

namespace {

using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::GreyImage;
using tecnogamma_camera::ImageView16;
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

/// Processor time [s] of this thread: other load on the machine is not counted.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Median times [s] of calls that take turns, so that all see the same machine load.
std::vector<double> median_times(const std::vector<std::function<void()>>& calls) {
  constexpr int kRounds = 101;  // odd: one of them is the median; chosen
  std::vector<std::vector<double>> times(calls.size());
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < calls.size(); ++i) {
      const double start = processor_time();
      calls[i]();
      times[i].push_back(processor_time() - start);
    }
  }
  std::vector<double> medians;
  for (auto& of_call : times) {
    std::nth_element(of_call.begin(), of_call.begin() + kRounds / 2, of_call.end());
    medians.push_back(of_call[kRounds / 2]);
  }
  return medians;
}

/// The plain pass: the cost of only reading a frame.
[[gnu::noinline]] std::uint32_t sum_of_bytes(const std::uint8_t* bytes, std::size_t size) {
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < size; ++i)
    sum += bytes[i];
  return sum;
}

void print_time(const std::string& name, const cv::Mat& image, const GreyImage& view,
                int trigger_level) {
  DetectorSettings settings;
  settings.trigger_level = trigger_level;
  const auto detector = tecnogamma_camera::make_detector(name, settings);
  PeakProfile profile;
  std::vector<float> positions;
  volatile std::uint32_t sink = 0;
  const auto times = median_times(
      {[&] { sink = sum_of_bytes(image.data, image.total() * image.elemSize()); },
       [&] { detector->detect(view, profile); },
       [&] {
         if (view.bits == 8)
           tecnogamma_camera::detect_with_opencv(name, trigger_level, image, positions);
       }});
  std::printf("  %-18s %2d bit  %-9s %8.0f %8.0f %7.2f", name.c_str(), view.bits,
              trigger_level < 0 ? "automatic" : "given", times[1] * 1e6, times[0] * 1e6,
              times[1] / times[0]);
  if (view.bits == 8) {
    std::printf(" %9.0f %8.1f", times[2] * 1e6, times[2] / times[1]);
  } else {
    std::printf(" %9s %8s", "", "");
  }
  std::printf(" %8.0f\n", 1 / times[1]);
}

void bench(int columns, int rows) {
  const cv::Mat image = line_image(columns, rows);
  cv::Mat image16;
  image.convertTo(image16, CV_16U, 16);
  const ImageView8 view{image.data, columns, rows, columns, 0, 0};
  const ImageView16 view16{image16.ptr<std::uint16_t>(), columns, rows, columns, 0, 0};
  std::printf("%d x %d pixels, one core; a plain pass reads the frame's bytes\n", columns, rows);
  std::printf(
      "                              trigger       time     pass            OpenCV  times\n");
  std::printf(
      "                              level         [us]     [us]   ratio      [us]  faster "
      "frames/s\n");
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    for (const int level : {tecnogamma_camera::kAutomaticLevel, 60}) {
      print_time(name, image, view, level);
      print_time(name, image16, GreyImage(view16, 12), level < 0 ? level : 16 * level);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Speed and accuracy of the peak detectors");
  return scan_cell_common::tool_main("bench_tecnogamma_camera", app, argc, argv, [] {
    cv::setNumThreads(1);
    bench(1024, 512);
    bench(1696, 1710);
    tecnogamma_camera::print_peak_accuracy();
    return 0;
  });
}
