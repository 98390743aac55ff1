// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "scan_cell_common/errors.h"
#include "stripes.h"
#include "tecnogamma_camera/peak_detector.h"

using tecnogamma_camera::CenterOfGravityDetector;
using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::ImageView8;
using tecnogamma_camera::make_detector;
using tecnogamma_camera::PeakDetector;
using tecnogamma_camera::PeakProfile;
using tecnogamma_camera::ThresholdDetector;

namespace {

DetectorSettings settings(int trigger_level, int permanence, int window = 15) {
  DetectorSettings result;
  result.trigger_level = trigger_level;
  result.permanence = permanence;
  result.window = window;
  return result;
}

/// One row, written as a picture: '#' is lit (200), '+' brighter (250), '.' dark (10).
class Row {
 public:
  explicit Row(const std::string& picture) {
    for (const char mark : picture)
      pixels_.push_back(mark == '#' ? 200 : mark == '+' ? 250 : 10);
  }

  PeakProfile detect(const PeakDetector& detector) const {
    ImageView8 image;
    image.pixels = pixels_.data();
    image.columns = static_cast<int>(pixels_.size());
    image.rows = 1;
    image.stride = image.columns;
    PeakProfile profile;
    detector.detect(image, profile);
    return profile;
  }

 private:
  std::vector<std::uint8_t> pixels_;
};

float threshold_position(const std::string& picture, int permanence) {
  return Row(picture).detect(ThresholdDetector(settings(100, permanence))).position[0];
}

struct Errors {
  double mean = 0;
  double rms = 0;
  double worst = 0;
  int missing = 0;
};

/// Position errors of a profile whose truth in row i is first + i * step.
Errors errors(const PeakProfile& profile, double first, double step) {
  Errors result;
  int found = 0;
  for (int row = 0; row < profile.rows(); ++row) {
    const double error = profile.position[row] - (first + row * step);
    if (std::isnan(error)) {
      ++result.missing;
      continue;
    }
    ++found;
    result.mean += error;
    result.rms += error * error;
    result.worst = std::max(result.worst, std::abs(error));
  }
  result.mean /= found;
  result.rms = std::sqrt(result.rms / found);
  return result;
}

}  // namespace

TEST(ThresholdDetector, PutsThePeakInTheMiddleBetweenTheEdges) {
  const PeakProfile profile = Row("....####.....").detect(ThresholdDetector(settings(100, 2)));
  EXPECT_EQ(profile.position[0], 5.5F);
  EXPECT_EQ(profile.width[0], 4.0F);
  EXPECT_EQ(profile.intensity[0], 200.0F);
  EXPECT_EQ(threshold_position("....#####....", 2), 6.0F);
}

TEST(ThresholdDetector, NeedsAsManyLitPixelsInARowAsThePermanence) {
  EXPECT_EQ(threshold_position("...##......", 2), 3.5F);
  EXPECT_TRUE(std::isnan(threshold_position("...##......", 3)));
  EXPECT_TRUE(std::isnan(threshold_position("...##.##...", 3)));  // not consecutive
  EXPECT_EQ(threshold_position("...##.###.....", 3), 7.0F);  // the rise is the first valid edge
}

TEST(ThresholdDetector, NeedsAsManyDarkPixelsInARowAsThePermanence) {
  EXPECT_EQ(threshold_position("...###.###....", 2), 6.0F);    // a dip of one is bridged
  EXPECT_EQ(threshold_position("...##..###....", 2), 8.0F);    // of two parts two spots
  EXPECT_EQ(threshold_position("...##.#.#.##....", 2), 7.0F);  // several dips of one
}

TEST(ThresholdDetector, CallsAPixelLitOnlyAboveTheTriggerLevel) {
  EXPECT_TRUE(std::isnan(Row("...##...").detect(ThresholdDetector(settings(200, 2))).position[0]));
  EXPECT_EQ(Row("...##...").detect(ThresholdDetector(settings(199, 2))).position[0], 3.5F);
  EXPECT_TRUE(std::isnan(Row("..++++..").detect(ThresholdDetector(settings(255, 1))).position[0]));
}

TEST(ThresholdDetector, RefusesSpotsThatTheBorderCuts) {
  EXPECT_TRUE(std::isnan(threshold_position("###.......", 2)));
  EXPECT_TRUE(std::isnan(threshold_position(".......###", 2)));
  EXPECT_TRUE(std::isnan(threshold_position(".......##.", 2)));  // falling edge not complete
  EXPECT_EQ(threshold_position(".......##.", 1), 7.5F);
  EXPECT_EQ(threshold_position(".##.......", 2), 1.5F);
  EXPECT_TRUE(std::isnan(threshold_position("##########", 2)));
}

TEST(ThresholdDetector, TakesTheSpotWithTheMostLightAndTheLeftOfEquals) {
  EXPECT_EQ(threshold_position("..##....####...", 2), 9.5F);
  EXPECT_EQ(threshold_position("..###....+++...", 2), 10.0F);
  EXPECT_EQ(threshold_position("..###....###...", 2), 3.0F);
  EXPECT_EQ(threshold_position("..+++....###...", 2), 3.0F);
}

TEST(ThresholdDetector, DoesNotFallBackToAReflectionWhereTheLineIsCut) {
  EXPECT_TRUE(std::isnan(threshold_position("#####...##....", 2)));
  EXPECT_EQ(threshold_position("##...####....", 2), 6.5F);
}

TEST(ThresholdDetector, FindsSpotsAcrossTheBlocksOfTheFastSearch) {
  for (int start = 1; start < 300; ++start) {
    const std::string picture = std::string(start, '.') + "####" + std::string(310 - start, '.');
    ASSERT_EQ(threshold_position(picture, 2), start + 1.5F) << start;
  }
}

TEST(PeakDetector, GivesSensorCoordinatesInARegion) {
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    stripes::Image picture(64, 5);
    for (int row = 0; row < 5; ++row)
      picture.add(row, {30, 1.5, 180});
    ImageView8 image = picture.view();
    image.first_column = 400;
    image.first_row = 1000;
    PeakProfile profile;
    make_detector(name, settings(60, 2))->detect(image, profile);
    EXPECT_EQ(profile.first_row, 1000);
    for (const float position : profile.position)
      EXPECT_NEAR(position, 430, 1e-3) << name;
  }
}

TEST(PeakDetector, ReadsOnlyTheRegionOfAWiderImage) {
  stripes::Image picture(100, 3);
  for (int row = 0; row < 3; ++row) {
    picture.add(row, {20, 1.5, 180});
    picture.add(row, {80, 3, 250});
  }
  ImageView8 image = picture.view();
  image.columns = 50;
  PeakProfile profile;
  CenterOfGravityDetector(settings(60, 2)).detect(image, profile);
  for (const float position : profile.position)
    EXPECT_NEAR(position, 20, 1e-3);
}

TEST(PeakDetector, HasNoPeakInADarkAnEmptyOrATinyImage) {
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    const auto detector = make_detector(name, settings(60, 2));
    PeakProfile profile;
    stripes::Image dark(200, 7, 20);
    detector->detect(dark.view(), profile);
    EXPECT_EQ(profile.rows(), 7);
    for (int row = 0; row < 7; ++row) {
      EXPECT_TRUE(std::isnan(profile.position[row]));
      EXPECT_TRUE(std::isnan(profile.width[row]));
      EXPECT_TRUE(std::isnan(profile.intensity[row]));
    }
    detector->detect(ImageView8{}, profile);
    EXPECT_EQ(profile.rows(), 0);
    stripes::Image narrow(1, 4, 200);
    detector->detect(narrow.view(), profile);
    ASSERT_EQ(profile.rows(), 4);
    EXPECT_TRUE(std::isnan(profile.position[0]));
  }
}

TEST(PeakDetector, RefusesSettingsOutOfRangeByName) {
  const auto refused = [](const DetectorSettings& bad) -> std::string {
    try {
      make_detector("threshold", bad);
    } catch (const scan_cell_common::InvalidParameter& error) {
      return error.thing();
    }
    return "nothing";
  };
  EXPECT_EQ(refused(settings(256, 2)), "trigger_level");
  EXPECT_EQ(refused(settings(-1, 2)), "trigger_level");
  EXPECT_EQ(refused(settings(60, 0)), "permanence");
  EXPECT_EQ(refused(settings(60, 2, 1)), "window");
  EXPECT_THROW(make_detector("parabola", {}), scan_cell_common::InvalidParameter);
}

TEST(CenterOfGravityDetector, FindsAGaussianStripeAtEverySubPixelPhase) {
  constexpr int kRows = 200;
  for (const double sigma : {1.2, 1.5, 2.0}) {
    stripes::Image picture(80, kRows, 12);
    for (int row = 0; row < kRows; ++row)
      picture.add(row, {40 + row * 0.01, sigma, 200});
    PeakProfile profile;
    CenterOfGravityDetector(settings(60, 2)).detect(picture.view(), profile);
    const Errors found = errors(profile, 40, 0.01);
    EXPECT_EQ(found.missing, 0);
    EXPECT_LT(found.worst, 0.03) << sigma;  // four sigma of the 8 bit rounding
    EXPECT_LT(std::abs(found.mean), 0.002) << sigma;
  }
}

TEST(CenterOfGravityDetector, DoesNotMindABackground) {
  constexpr int kRows = 100;
  stripes::Image picture(80, kRows, 50);
  for (int row = 0; row < kRows; ++row)
    picture.add(row, {40 + row * 0.01, 1.5, 150});
  PeakProfile profile;
  CenterOfGravityDetector(settings(80, 2)).detect(picture.view(), profile);
  EXPECT_LT(errors(profile, 40, 0.01).worst, 0.02);
}

TEST(CenterOfGravityDetector, IsUnbiasedInNoiseAndScattersAsThePlainErrorLawSays) {
  constexpr int kRows = 20000;
  constexpr double kSigma = 1.5, kHeight = 200, kNoise = 3;
  stripes::Image picture(80, kRows, 15);
  for (int row = 0; row < kRows; ++row)
    picture.add(row, {40 + row * 1e-4, kSigma, kHeight});
  picture.add_noise(kNoise, 7);
  PeakProfile profile;
  CenterOfGravityDetector(settings(60, 2, 13)).detect(picture.view(), profile);
  const Errors found = errors(profile, 40, 1e-4);
  EXPECT_EQ(found.missing, 0);
  EXPECT_LT(std::abs(found.mean), 0.002);
  // Noise of each pixel times its lever arm over the light of the stripe.
  double lever = 0;
  for (int offset = -6; offset <= 6; ++offset)
    lever += offset * offset;
  const double expected = kNoise * std::sqrt(lever) / (kHeight * kSigma * std::sqrt(2 * M_PI));
  EXPECT_LT(found.rms, 1.25 * expected);
  EXPECT_GT(found.rms, 0.8 * expected);
}

TEST(CenterOfGravityDetector, IsUnbiasedOnSaturatedStripes) {
  constexpr int kRows = 200;
  stripes::Image picture(80, kRows, 10);
  for (int row = 0; row < kRows; ++row)
    picture.add(row, {40 + row * 0.01, 2.0, 900});
  PeakProfile profile;
  CenterOfGravityDetector(settings(60, 2, 17)).detect(picture.view(), profile);
  const Errors found = errors(profile, 40, 0.01);
  EXPECT_EQ(found.missing, 0);
  EXPECT_LT(found.worst, 0.05);
  EXPECT_LT(std::abs(found.mean), 0.005);
  for (const float intensity : profile.intensity)
    EXPECT_EQ(intensity, 255.0F);
}

TEST(CenterOfGravityDetector, IsNotDrawnToAReflectionNextToTheLine) {
  stripes::Image picture(120, 1, 10);
  picture.add(0, {50.3, 1.5, 200});
  picture.add(0, {60.0, 1.2, 150});
  PeakProfile profile;
  CenterOfGravityDetector(settings(60, 2, 31)).detect(picture.view(), profile);
  EXPECT_NEAR(profile.position[0], 50.3, 0.1);  // 31 columns would reach over both
}

TEST(CenterOfGravityDetector, KeepsAStripeAtTheBorderUnbiasedOrRefusesIt) {
  stripes::Image picture(60, 2, 10);
  picture.add(0, {5.25, 1.5, 200});
  picture.add(1, {0.5, 1.5, 200});
  PeakProfile profile;
  CenterOfGravityDetector(settings(60, 2)).detect(picture.view(), profile);
  EXPECT_NEAR(profile.position[0], 5.25, 0.05);
  EXPECT_TRUE(std::isnan(profile.position[1]));
}
