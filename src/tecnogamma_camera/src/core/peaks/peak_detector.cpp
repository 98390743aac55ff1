// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "peaks/background.h"
#include "peaks/peak_locators.h"
#include "peaks/spots.h"
#include "peaks/stripe.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace tecnogamma_camera {
namespace {

using scan_cell_common::InvalidParameter;

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
    for (first_ = 0; first_ < image_.rows; first_ += kBlockRows) {
      const int rows = std::min(kBlockRows, image_.rows - first_);
      if (automatic()) levels_.follow(background_, first_, rows);
      for (int i = 0; i < rows; ++i)
        find_spot(i, image_.row(first_ + i));
      if (needs_stripe()) find_stripes(rows);
      for (int i = 0; i < rows; ++i)
        if (spots_[i].fall > 0) locate(i, profile);
    }
  }

 private:
  static constexpr int kBlockRows = 32;  // [px] that share their trigger levels; chosen

  bool automatic() const { return settings_.trigger_level == kAutomaticLevel; }
  bool needs_stripe() const { return automatic() || Locate::kNeedsStripe; }

  /// Finds the spot of a row. Its fall is 0 if there is none or, with a given trigger level, if it
  /// is cut.
  void find_spot(int i, const Pixel* row) {
    rows_[i] = row;
    lit_.mark(row, image_.columns, levels_.levels());
    const Spot spot = choose_spot(
        row, image_.columns, lit_, levels_, settings_,
        [&](const Spot& candidate) {
          return settings_.max_width == 0 || width_of(i, candidate) <= settings_.max_width;
        },
        hot_);
    spots_[i] = spot.cut && !automatic() ? Spot{} : spot;
    for (const int column : hot_) {
      const int width = spot.fall - spot.rise;
      if (column >= spot.rise - width && column < spot.fall + width) replace(i, column);
    }
  }

  /// Replaces a pixel by the mean of its neighbours, in a copy of the row.
  void replace(int i, int column) {
    if (column == 0 || column == image_.columns - 1) return;
    std::vector<Pixel>& copy = repaired_[i];
    if (rows_[i] != copy.data()) copy.assign(rows_[i], rows_[i] + image_.columns);
    copy[column] = static_cast<Pixel>((copy[column - 1] + copy[column + 1]) / 2);
    rows_[i] = copy.data();
  }

  void find_stripes(int rows) {
    for (int i = 0; i < rows; ++i)
      heights_[i] = height_of(i, spots_[i]);
    for (int i = 0; i < rows; ++i)
      if (is_hot(rows_[i], image_.columns, spots_[i], heights_[i])) repair(i);
    for (int i = 0; i < rows; ++i)
      stripes_[i] = find_stripe(rows_[i], image_.columns, spots_[i], heights_[i]);
  }

  void repair(int i) {
    constexpr int kMost = 8;  // hot pixels in a row; chosen
    for (int n = 0; n < kMost && is_hot(rows_[i], image_.columns, spots_[i], heights_[i]); ++n) {
      replace(i, heights_[i].anchor);
      find_spot(i, rows_[i]);
      heights_[i] = height_of(i, spots_[i]);
    }
  }

  Height height_of(int i, const Spot& spot) {
    if (spot.fall == 0) return {};
    return measure_height(rows_[i], spot,
                          background_.about(first_ + i, (spot.rise + spot.fall) / 2),
                          settings_.permanence);
  }

  Edges edges_of(int i, const Spot& spot, const Stripe& stripe) const {
    return automatic() ? edges_at_half(rows_[i], stripe)
                       : edges_at(rows_[i], spot, settings_.trigger_level);
  }

  /// [px] as in the profile; of a cut spot, the visible part.
  double width_of(int i, const Spot& spot) {
    if (!automatic()) return spot.cut ? spot.fall - spot.rise : edges_of(i, spot, {}).width();
    const Stripe stripe = find_stripe(rows_[i], image_.columns, spot, height_of(i, spot));
    return stripe.cut ? stripe.fall - stripe.rise : edges_of(i, spot, stripe).width();
  }

  void locate(int i, PeakProfile& profile) {
    const Pixel* const row = rows_[i];
    const Stripe& stripe = stripes_[i];
    if (needs_stripe() && (stripe.half_height == 0 || stripe.cut)) return;
    const Edges edges = edges_of(i, spots_[i], stripe);
    const double column = locate_(row, image_.columns, stripe, edges);
    if (std::isnan(column)) return;
    const int index = first_ + i;
    profile.position[index] = static_cast<float>(image_.first_column + column);
    profile.width[index] = static_cast<float>(edges.width());
    profile.intensity[index] =
        static_cast<float>(needs_stripe() ? stripe.brightest : brightest(row, spots_[i]));
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
  int first_ = 0;                              // row of the image, of the block's first
  std::array<const Pixel*, kBlockRows> rows_;  // of the image, or repaired
  std::array<std::vector<Pixel>, kBlockRows> repaired_;
  std::vector<int> hot_;
  std::array<Spot, kBlockRows> spots_;
  std::array<Height, kBlockRows> heights_;
  std::array<Stripe, kBlockRows> stripes_;
};

template <class Locate>
class StripeDetector : public PeakDetector {
 public:
  StripeDetector(const DetectorSettings& settings, const Locate& locate)
      : settings_(settings), locate_(locate) {
    scan_cell_common::check(settings_);
  }

  void detect(const GreyImage& image, PeakProfile& profile) const override {
    visit(image, [&](const auto& view) { FrameDetection(view, settings_, locate_).run(profile); });
  }

 private:
  const DetectorSettings settings_;
  const Locate locate_;
};

}  // namespace

void describe(scan_cell_common::ParameterTable& table, DetectorSettings& settings) {
  table.choice("choice", settings.choice, choice_names(),
               "which of several spots in a row is the laser's");
  table.add("trigger_level", settings.trigger_level, {kAutomaticLevel, 65535, "grey value"},
            "at the camera's own pixel depth (up to 4095 at 12 bits): pixels above it are lit; -1: "
            "automatic, above the noise of the background");
  table.add("permanence", settings.permanence, {1, 64, "px"},
            "how many consecutive lit pixels make a rising edge, and dark ones a falling edge");
  table.add("window", settings.window, {0, 255, "px"},
            "largest number of columns for the centre of gravity, but never fewer than the stripe "
            "has; 0: as its width requires");
  table.add("max_width", settings.max_width, {0, 65535, "px"},
            "spots whose `width` is greater than this (shiny objects) are ignored before the "
            "choice; 0: any width");
  table.renamed("most_width", "max_width");
}

const std::vector<std::string>& choice_names() {
  static const std::vector<std::string> names = {"brightest", "first", "last"};
  return names;
}

Choice choice_of(const std::string& name) {
  const auto& names = choice_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<Choice>(found - names.begin());
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
