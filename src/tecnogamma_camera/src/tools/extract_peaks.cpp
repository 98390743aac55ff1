// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tecnogamma_camera/grey_image_file.h"
#include "tecnogamma_camera/peak_detector.h"
#include "tecnogamma_camera/peak_file.h"

namespace {

using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::GreyImage;
using tecnogamma_camera::PeakProfile;

void extract(const std::string& image_path, const std::string& output_path,
             const std::string& detector_name, const DetectorSettings& settings) {
  const auto detector = tecnogamma_camera::make_detector(detector_name, settings);
  const cv::Mat image = tecnogamma_camera::load_grey_image(image_path);
  const GreyImage view = tecnogamma_camera::grey_view(image);
  if (settings.trigger_level > view.greatest_grey_value()) {
    throw scan_cell_common::InvalidParameter(
        "trigger_level", fmt::format("{}", settings.trigger_level),
        fmt::format("grey values of this image end at {}", view.greatest_grey_value()));
  }
  PeakProfile profile;
  detector->detect(view, profile);
  tecnogamma_camera::save_peaks(output_path, profile);
  int peaks = 0;
  for (const float position : profile.position)
    peaks += std::isnan(position) ? 0 : 1;
  std::printf("%d peaks in %d rows\n", peaks, view.rows);
}

}  // namespace

/// Writes the peaks of one image to a CSV file. Exits 0, or 1 on unusable input.
int main(int argc, char** argv) {
  scan_cell_common::Outputs outputs;
  CLI::App app("Finds the laser line in an image: one peak per row, written as CSV");
  app.option_defaults()->always_capture_default();
  std::string image, output, detector = "fir_derivative";
  DetectorSettings settings;
  app.add_option("--image", image, "8 or 16 bit grey pixels; the line runs vertically")->required();
  outputs.add(app, "--output", output, "CSV: row,position,width,intensity")->required();
  app.add_option("--detector", detector, "threshold, center_of_gravity or fir_derivative");
  scan_cell_common::ParameterOptions typed;
  typed.add(app, settings);
  return scan_cell_common::tool_main(
      "extract_peaks", app, argc, argv,
      [&] {
        typed.read(settings);
        extract(image, output, detector, settings);
        return 0;
      },
      scan_cell_common::kUnusable, outputs);
}
