// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <opencv2/imgcodecs.hpp>

#include "scan_cell_common/errors.h"
#include "tecnogamma_camera/peak_detector.h"
#include "tecnogamma_camera/peak_file.h"

namespace {

cv::Mat load_image(const std::string& path) {
  cv::Mat image;
  try {
    image = cv::imread(path, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    throw scan_cell_common::FileError(path, error.err, "give a PNG of 8 bit grey pixels");
  }
  if (image.empty()) {
    throw scan_cell_common::FileError(path, "cannot be read as an image",
                                      "give a PNG of 8 bit grey pixels");
  }
  if (image.type() != CV_8UC1) {
    throw scan_cell_common::UnusableInput(path, cv::typeToString(image.type()) + " pixels",
                                          "convert it to 8 bit grey");
  }
  return image;
}

void extract(const std::string& image_path, const std::string& output_path,
             const tecnogamma_camera::PeakDetector& detector) {
  const cv::Mat image = load_image(image_path);
  tecnogamma_camera::ImageView8 view;
  view.pixels = image.data;
  view.columns = image.cols;
  view.rows = image.rows;
  view.stride = static_cast<std::ptrdiff_t>(image.step);
  tecnogamma_camera::PeakProfile profile;
  detector.detect(view, profile);
  tecnogamma_camera::save_peaks(output_path, profile);
  int peaks = 0;
  for (const float position : profile.position)
    peaks += std::isnan(position) ? 0 : 1;
  std::printf("%d peaks in %d rows\n", peaks, view.rows);
}

}  // namespace

/// Peaks of one image to a CSV file. Exits 0, or 1 on unusable input.
int main(int argc, char** argv) {
  CLI::App app("Finds the laser line in an image: one peak a row, written as CSV");
  app.option_defaults()->always_capture_default();
  std::string image, output, detector = "center_of_gravity";
  tecnogamma_camera::DetectorSettings settings;
  app.add_option("--image", image, "PNG of 8 bit grey pixels; the line runs vertically")
      ->required();
  app.add_option("--output", output, "CSV: row,position,width,intensity")->required();
  app.add_option("--detector", detector, "threshold or center_of_gravity");
  app.add_option("--trigger-level", settings.trigger_level, "grey value, 0 .. 255");
  app.add_option("--permanence", settings.permanence, "pixels that make an edge");
  app.add_option("--window", settings.window, "columns of the centre of gravity");
  CLI11_PARSE(app, argc, argv);
  try {
    extract(image, output, *tecnogamma_camera::make_detector(detector, settings));
    return 0;
  } catch (const scan_cell_common::Error& error) {
    std::fprintf(stderr, "extract_peaks: %s\n", error.what());
    return 1;
  }
}
