// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_detector.h"

#include "scan_cell_common/errors.h"
#include "spots.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;

void check_range(const char* name, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw InvalidParameter(
      name, std::to_string(value),
      "give a value from " + std::to_string(least) + " to " + std::to_string(most));
}

}  // namespace

void DetectorSettings::check() const {
  check_range("trigger_level", trigger_level, 0, 255);
  check_range("permanence", permanence, 1, 64);
  check_range("window", window, 3, 255);
}

ThresholdDetector::ThresholdDetector(const DetectorSettings& settings) : settings_(settings) {
  settings_.check();
}

void ThresholdDetector::detect(const ImageView8& image, PeakProfile& profile) const {
  detect_rows(
      image, settings_, [](const auto*, const Spot& spot) { return spot.middle(); }, profile);
}

CenterOfGravityDetector::CenterOfGravityDetector(const DetectorSettings& settings)
    : settings_(settings) {
  settings_.check();
}

void CenterOfGravityDetector::detect(const ImageView8& image, PeakProfile& profile) const {
  const auto locate = [window = settings_.window](const auto* row, const Spot& spot) {
    return center_of_gravity(row, spot, window);
  };
  detect_rows(image, settings_, locate, profile);
}

const std::vector<std::string>& detector_names() {
  static const std::vector<std::string> names = {"center_of_gravity", "threshold"};
  return names;
}

std::unique_ptr<PeakDetector> make_detector(const std::string& name,
                                            const DetectorSettings& settings) {
  if (name == "threshold") return std::make_unique<ThresholdDetector>(settings);
  if (name == "center_of_gravity") return std::make_unique<CenterOfGravityDetector>(settings);
  throw InvalidParameter("detector", "'" + name + "'", "give threshold or center_of_gravity");
}

}  // namespace tecnogamma_camera
