// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "laser_lines/line_peaks.h"

#include <algorithm>
#include <cmath>

#include "tecnogamma_camera/grey_image_file.h"
#include "tecnogamma_camera/peak_detector.h"

namespace scan_calibration {
namespace {

using tecnogamma_camera::Choice;
using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::PeakProfile;

/// Ways to look for the line. The automatic level finds it in the dark; beside bright squares, only
/// what is nearly the brightest is laser light.
std::vector<DetectorSettings> ways(double brightest) {
  std::vector<DetectorSettings> result(1);
  for (const double share : {0.5, 0.85}) {  // of the brightest grey value, chosen
    for (const Choice choice : {Choice::kBrightest, Choice::kFirst, Choice::kLast}) {
      DetectorSettings settings;
      settings.trigger_level = static_cast<int>(share * brightest);
      settings.choice = choice;
      result.push_back(settings);
    }
  }
  return result;
}

/// A stripe that was found in several ways counts once, as found first.
void add_new(const PeakProfile& profile, std::vector<std::vector<LinePeak>>& rows) {
  for (int i = 0; i < profile.rows(); ++i) {
    if (std::isnan(profile.position[i])) continue;
    const LinePeak peak{{profile.position[i], profile.first_row + i}, profile.width[i]};
    std::vector<LinePeak>& known = rows[static_cast<std::size_t>(i)];
    const bool is_known = std::any_of(known.begin(), known.end(), [&](const LinePeak& other) {
      const double apart = std::abs(other.pixel.x() - peak.pixel.x());
      return apart < 0.5 * std::max(other.width, peak.width) + 1;  // [px] half of it and rounding
    });
    if (!is_known) known.push_back(peak);
  }
}

std::vector<LinePeak> peaks_across_rows(const cv::Mat& image, const std::string& detector) {
  double brightest = 0;
  cv::minMaxLoc(image, nullptr, &brightest);
  std::vector<std::vector<LinePeak>> rows(static_cast<std::size_t>(image.rows));
  PeakProfile profile;
  for (const DetectorSettings& settings : ways(brightest)) {
    tecnogamma_camera::make_detector(detector, settings)
        ->detect(tecnogamma_camera::grey_view(image), profile);
    add_new(profile, rows);
  }
  std::vector<LinePeak> result;
  for (const auto& row : rows)
    result.insert(result.end(), row.begin(), row.end());
  return result;
}

}  // namespace

LinePeaks line_peaks(const PeakProfile& profile) {
  std::vector<std::vector<LinePeak>> rows(static_cast<std::size_t>(profile.rows()));
  add_new(profile, rows);
  LinePeaks result;
  for (const auto& row : rows)
    result.peaks.insert(result.peaks.end(), row.begin(), row.end());
  return result;
}

std::vector<LinePeaks> line_peaks(const cv::Mat& image, const std::string& detector) {
  LinePeaks upright{true, peaks_across_rows(image, detector)};
  cv::Mat transposed;
  cv::transpose(image, transposed);
  LinePeaks lying{false, peaks_across_rows(transposed, detector)};
  for (LinePeak& peak : lying.peaks)
    peak.pixel.reverseInPlace();
  return {upright, lying};
}

}  // namespace scan_calibration
