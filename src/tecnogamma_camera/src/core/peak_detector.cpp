// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_detector.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "background.h"
#include "peak_locators.h"
#include "scan_cell_common/errors.h"
#include "spots.h"
#include "stripe.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;

void check_range(const char* name, int value, int least, int most) {
  if (value >= least && value <= most) return;
  throw InvalidParameter(
      name, std::to_string(value),
      "give a value from " + std::to_string(least) + " to " + std::to_string(most));
}

/// Detection in one frame; `locate(row, columns, stripe, edges)` gives the column of the peak.
template <class Pixel, class Locate>
class FrameDetection {
 public:
  FrameDetection(const ImageView<Pixel>& image, const DetectorSettings& settings,
                 const Locate& locate)
      : image_(image),
        settings_(settings),
        locate_(locate),
        background_(image),
        levels_(image.columns, settings.trigger_level) {}

  void run(PeakProfile& profile) {
    profile.clear(image_.first_row, image_.rows);
    for (int first = 0; first < image_.rows; first += kBlockRows) {
      if (automatic() && first % Background<Pixel>::kBandRows == 0)
        levels_.follow(background_, first);
      const int rows = std::min(kBlockRows, image_.rows - first);
      for (int i = 0; i < rows; ++i)
        spots_[i] = find_spot(first + i);
      if (needs_stripe()) {
        for (int i = 0; i < rows; ++i)
          heights_[i] = height_of(first + i, spots_[i]);
        for (int i = 0; i < rows; ++i)
          stripes_[i] = find_stripe(image_.row(first + i), image_.columns, spots_[i], heights_[i]);
      }
      for (int i = 0; i < rows; ++i)
        if (spots_[i].fall > 0) locate(first + i, spots_[i], stripes_[i], profile);
    }
  }

 private:
  static constexpr int kBlockRows = 32;

  bool automatic() const { return settings_.trigger_level == kAutomaticLevel; }
  bool needs_stripe() const { return automatic() || Locate::kNeedsStripe; }

  /// Its fall is 0 where the row has none, or one that is cut.
  Spot find_spot(int index) {
    const Pixel* const row = image_.row(index);
    lit_.mark(row, image_.columns, levels_.of_tiles());
    const Spot spot = choose_spot(row, image_.columns, lit_, levels_, settings_);
    return spot.cut && !automatic() ? Spot{} : spot;
  }

  Height height_of(int index, const Spot& spot) {
    if (spot.fall == 0) return {};
    return measure_height(image_.row(index), spot,
                          background_.about(index, (spot.rise + spot.fall) / 2),
                          settings_.permanence);
  }

  void locate(int index, const Spot& spot, const Stripe& stripe, PeakProfile& profile) {
    const Pixel* const row = image_.row(index);
    if (needs_stripe() && (stripe.half_height == 0 || stripe.cut)) return;
    const Edges edges =
        automatic() ? edges_at_half(row, stripe) : edges_at(row, spot, settings_.trigger_level);
    const double column = locate_(row, image_.columns, stripe, edges);
    if (std::isnan(column)) return;
    profile.position[index] = static_cast<float>(image_.first_column + column);
    profile.width[index] = static_cast<float>(edges.width());
    profile.intensity[index] =
        static_cast<float>(needs_stripe() ? stripe.brightest : brightest(row, spot));
  }

  static int brightest(const Pixel* row, const Spot& spot) {
    return *std::max_element(row + spot.rise, row + spot.fall);
  }

  const ImageView<Pixel> image_;
  const DetectorSettings& settings_;
  const Locate& locate_;
  Background<Pixel> background_;
  TriggerLevels<Pixel> levels_;
  LitPixels lit_;
  std::array<Spot, kBlockRows> spots_;
  std::array<Height, kBlockRows> heights_;
  std::array<Stripe, kBlockRows> stripes_;
};

template <class Locate>
class StripeDetector : public PeakDetector {
 public:
  StripeDetector(const DetectorSettings& settings, const Locate& locate)
      : settings_(settings), locate_(locate) {
    settings_.check();
  }

  void detect(const GreyImage& image, PeakProfile& profile) const override {
    visit(image, [&](const auto& view) { FrameDetection(view, settings_, locate_).run(profile); });
  }

 private:
  const DetectorSettings settings_;
  const Locate locate_;
};

}  // namespace

void DetectorSettings::check() const {
  check_range("trigger_level", trigger_level, kAutomaticLevel, 65535);
  check_range("permanence", permanence, 1, 64);
  check_range("window", window, 0, 255);
}

const std::vector<std::string>& choice_names() {
  static const std::vector<std::string> names = {"brightest", "first", "last"};
  return names;
}

Choice to_choice(const std::string& name) {
  if (name == "brightest") return Choice::BRIGHTEST;
  if (name == "first") return Choice::FIRST;
  if (name == "last") return Choice::LAST;
  throw InvalidParameter("choice", "'" + name + "'", "give brightest, first or last");
}

const std::vector<std::string>& detector_names() {
  static const std::vector<std::string> names = {"center_of_gravity", "fir_derivative",
                                                 "threshold"};
  return names;
}

std::unique_ptr<PeakDetector> make_detector(const std::string& name,
                                            const DetectorSettings& settings) {
  const auto make = [&](const auto& locate) -> std::unique_ptr<PeakDetector> {
    return std::make_unique<StripeDetector<std::decay_t<decltype(locate)>>>(settings, locate);
  };
  if (name == "threshold") return make(ThresholdLocator{});
  if (name == "center_of_gravity") return make(CenterOfGravityLocator{settings.window});
  if (name == "fir_derivative") return make(FirDerivativeLocator{});
  throw InvalidParameter("detector", "'" + name + "'",
                         "give threshold, center_of_gravity or fir_derivative");
}

}  // namespace tecnogamma_camera
