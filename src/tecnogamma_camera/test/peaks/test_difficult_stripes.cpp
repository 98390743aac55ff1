// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "peaks/stripes.h"
#include "tecnogamma_camera/peak_detector.h"

using stripes::Stripe;
using tecnogamma_camera::Choice;
using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::make_detector;
using tecnogamma_camera::PeakProfile;

namespace {

constexpr int kColumns = 640;
constexpr int kRows = 400;
constexpr double kBackground = 12;  // [grey value]

/// A slanting line, over every sub-pixel phase.
double line(int row) {
  return 300 + row * 0.137;
}

struct Errors {
  double mean = 0;
  double rms = 0;
  double worst = 0;
  int missing = 0;
};

Errors errors(const PeakProfile& profile, const std::function<double(int)>& truth = line) {
  Errors result;
  double squares = 0;
  for (int row = 0; row < profile.rows(); ++row) {
    const double error = profile.position[row] - truth(row);
    if (std::isnan(error)) {
      ++result.missing;
      continue;
    }
    result.mean += error;
    squares += error * error;
    result.worst = std::max(result.worst, std::abs(error));
  }
  const int found = std::max(1, profile.rows() - result.missing);
  result.mean /= found;
  result.rms = std::sqrt(squares / found);
  return result;
}

int peaks(const PeakProfile& profile) {
  return profile.rows() - errors(profile).missing;
}

stripes::Image line_image(const Stripe& stripe, double background = kBackground) {
  stripes::Image image(kColumns, kRows, background);
  for (int row = 0; row < kRows; ++row)
    image.add(row, {line(row), stripe.sigma, stripe.height});
  return image;
}

/// Each detector with its defaults or with other settings: nothing is tuned to the image.
class EachDetector : public testing::TestWithParam<std::string> {
 protected:
  PeakProfile detect(stripes::Image& image, const DetectorSettings& settings = {}) const {
    PeakProfile profile;
    make_detector(GetParam(), settings)->detect(image.view(), profile);
    return profile;
  }
};

INSTANTIATE_TEST_SUITE_P(, EachDetector, testing::ValuesIn(tecnogamma_camera::detector_names()),
                         [](const auto& test) { return test.param; });

}  // namespace

TEST_P(EachDetector, FindsEveryRowOfNarrowToWideAndFaintToSaturatedStripes) {
  for (const double sigma : {0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    for (const double height : {25.0, 60.0, 200.0, 400.0, 2000.0}) {
      stripes::Image image = line_image({0, sigma, height});
      image.add_noise(1.5, 3);
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << sigma << " px, " << height;
      EXPECT_LT(std::abs(found.mean), 0.06) << sigma << " px, " << height;
      EXPECT_LT(found.worst, height < 50 ? 1.2 : 0.5) << sigma << " px, " << height;
    }
  }
}

TEST_P(EachDetector, NeedsNeitherNoiseNorABackground) {
  for (const double sigma : {0.7, 1.0, 2.0, 6.0}) {
    for (const double background : {0.0, 3.0, 100.0}) {
      stripes::Image image = line_image({0, sigma, 150}, background);
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << sigma << " px on " << background;
      EXPECT_LT(found.worst, 0.05) << sigma << " px on " << background;
    }
  }
}

TEST_P(EachDetector, FindsNothingInNoise) {
  for (const double background : {0.0, 2.0, 6.0, 100.0}) {  // the low ones cut it off at black
    for (const double noise : {0.3, 1.0, 2.0, 4.0, 8.0, 25.0}) {
      stripes::Image image(kColumns, kRows, background);
      image.add_noise(noise, 5);
      EXPECT_EQ(peaks(detect(image)), 0) << noise << " on " << background;
    }
  }
}

TEST_P(EachDetector, FindsFaintLinesInNoiseThatIsCutOffAtBlack) {
  for (const double background : {0.0, 3.0}) {
    for (const double sigma : {1.0, 2.0, 6.0}) {
      stripes::Image image = line_image({0, sigma, 30}, background);
      image.add_noise(2, 3);
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << sigma << " px on " << background;
      EXPECT_LT(found.worst, 0.3 + 0.25 * sigma) << sigma << " px on " << background;
    }
  }
}

TEST_P(EachDetector, LeavesRowsWithoutALineOutAmongRowsWithOne) {
  stripes::Image image(kColumns, kRows, kBackground);
  for (int row = 0; row < kRows; row += 2)
    image.add(row, {line(row), 2, 100});
  image.add_noise(3, 3);
  const PeakProfile profile = detect(image);
  for (int row = 0; row < kRows; ++row)
    EXPECT_EQ(std::isnan(profile.position[row]), row % 2 == 1) << row;
}

TEST_P(EachDetector, FollowsAnAmbientGradient) {
  for (const double slope : {0.1, 0.2, -0.2}) {
    for (const bool down : {false, true}) {
      stripes::Image image = line_image({0, 2, 25}, slope < 0 ? 150 : 10);
      for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column)
          image.at(row, column) += slope * (down ? row : column);
      image.add_noise(1.5, 3);
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << slope << (down ? " down" : " across");
      EXPECT_LT(std::abs(found.mean), 0.03) << slope << (down ? " down" : " across");
      EXPECT_LT(found.worst, 0.6) << slope << (down ? " down" : " across");
    }
  }
}

TEST_P(EachDetector, FindsNothingInAnAmbientGradient) {
  for (const double slope : {0.1, 0.3}) {
    stripes::Image image(kColumns, kRows, 10);
    for (int row = 0; row < kRows; ++row)
      for (int column = 0; column < kColumns; ++column)
        image.at(row, column) += slope * std::hypot(column, row / 2);
    image.add_noise(1.5, 3);
    EXPECT_EQ(peaks(detect(image)), 0) << slope;
  }
}

TEST_P(EachDetector, TakesTheLineAndNotItsWeakerReflection) {
  for (const double distance : {-60.0, -12.0, 10.0, 30.0}) {
    for (const double height : {60.0, 120.0}) {
      stripes::Image image = line_image({0, 2, 180});
      for (int row = 0; row < kRows; ++row)
        image.add(row, {line(row) + distance, 2, height});
      image.add_noise(1.5, 3);
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << distance << " px, " << height;
      EXPECT_LT(found.worst, 0.2) << distance << " px, " << height;
    }
  }
}

TEST_P(EachDetector, TakesTheSideThatIsChosenAmongReflections) {
  stripes::Image image = line_image({0, 2, 80});
  for (int row = 0; row < kRows; ++row) {
    image.add(row, {line(row) - 100, 2, 60});
    image.add(row, {line(row) + 100, 3, 250});
  }
  image.add_noise(1.5, 3);
  DetectorSettings settings;
  settings.choice = Choice::kFirst;
  EXPECT_LT(errors(detect(image, settings), [](int row) { return line(row) - 100; }).worst, 0.3);
  settings.choice = Choice::kLast;
  EXPECT_LT(errors(detect(image, settings), [](int row) { return line(row) + 100; }).worst, 0.3);
}

TEST_P(EachDetector, PassesOverWhatIsWiderThanALineCanBe) {
  stripes::Image image = line_image({0, 4, 1500});
  for (int row = 0; row < kRows; ++row) {
    image.add(row, {line(row) + 200, row % 2 ? 25.0 : 15.0, 400});  // a shiny object, saturated too
    if (row % 3 == 0) image.add(row, {0, 60, 600});  // another, which the border cuts
  }
  image.add_noise(1.5, 3);
  EXPECT_GT(errors(detect(image)).worst, 100);
  DetectorSettings settings;
  settings.max_width = 30;
  const Errors found = errors(detect(image, settings));
  EXPECT_EQ(found.missing, 0);
  EXPECT_LT(found.worst, 0.5);
  settings.max_width = 5;
  EXPECT_LT(peaks(detect(image, settings)), 5) << "all but noise";
}

TEST_P(EachDetector, BridgesTheDipsOfSpeckle) {
  std::mt19937 engine(5);
  stripes::Image image(kColumns, kRows, kBackground);
  constexpr double kSigma = 3, kContrast = 0.2;
  for (int row = 0; row < kRows; ++row)
    image.add_speckled(row, {line(row), kSigma, 120}, kContrast, engine);
  image.add_noise(1.5, 3);
  const Errors found = errors(detect(image));
  EXPECT_EQ(found.missing, 0);
  EXPECT_LT(std::abs(found.mean), 0.03);
  // For the centre of gravity of the whole stripe, where each pixel scatters by contrast x its
  // light.
  const double whole = kContrast * std::sqrt(kSigma / (4 * std::sqrt(M_PI)));
  EXPECT_LT(found.rms, 2.5 * whole);
}

TEST_P(EachDetector, IsHardlyDrawnIntoATranslucentMaterial) {
  stripes::Image image(kColumns, kRows, kBackground);
  for (int row = 0; row < kRows; ++row)
    image.add_translucent(row, {line(row), 1.5, 150}, 5, 0.4);
  image.add_noise(1.5, 3);
  const Errors found = errors(detect(image));
  EXPECT_EQ(found.missing, 0);
  // The centre of gravity of all of the light; that of the tail lies one length deep.
  const double tail = 0.4 * 5 / 1.5;
  EXPECT_LT(found.mean, 0.33 * 5 * tail / (1 + tail));
  EXPECT_GT(found.mean, 0);
  EXPECT_LT(found.worst - found.mean, 0.2) << "the same in every row";
}

TEST_P(EachDetector, EndsWhereTheLineLeavesTheImage) {
  for (const bool right : {false, true}) {
    const auto truth = [&](int row) {
      return right ? kColumns - 41 + 0.137 * row : 40 - 0.137 * row;
    };
    stripes::Image image(kColumns, kRows, kBackground);
    for (int row = 0; row < kRows; ++row)
      image.add(row, {truth(row), 2, 150});
    image.add_noise(2, 3);
    const PeakProfile profile = detect(image);
    for (int row = 0; row < kRows; ++row) {
      const double inside = right ? kColumns - 1 - truth(row) : truth(row);
      const bool found = !std::isnan(profile.position[row]);
      EXPECT_TRUE(found || inside <= 8) << inside;
      EXPECT_TRUE(!found || inside >= 2) << inside;
      EXPECT_TRUE(!found || std::abs(profile.position[row] - truth(row)) < 0.15) << inside;
    }
  }
}

TEST_P(EachDetector, PassesOverSingleHotAndDeadPixels) {
  stripes::Image image = line_image({0, 2, 100});
  image.add_noise(2, 3);
  for (int row = 0; row < kRows; ++row) {
    for (int column = row % 7; column < kColumns; column += 29) {
      if (std::abs(column - line(row)) > 12) image.at(row, column) = column % 2 ? 255 : 0;
    }
  }
  const Errors found = errors(detect(image));
  EXPECT_EQ(found.missing, 0);
  EXPECT_LT(found.worst, 0.4);
}

TEST_P(EachDetector, IsNotMisledByAHotPixelBesideTheLine) {
  for (const double height : {30.0, 60.0, 120.0}) {
    for (int off = 5; off <= 14; ++off) {
      stripes::Image image = line_image({0, 2, height});
      image.add_noise(1.5, 3);
      for (int row = 0; row < kRows; row += 3)
        image.at(row, static_cast<int>(line(row)) + (row % 2 ? off : -off)) = 255;
      const Errors found = errors(detect(image));
      EXPECT_EQ(found.missing, 0) << height << ", " << off << " px off";
      EXPECT_LT(found.worst, height < 50 ? 0.9 : 0.5) << height << ", " << off << " px off";
    }
  }
}

TEST_P(EachDetector, TakesNoThinLineForHotPixels) {
  for (const double sigma : {0.25, 0.4, 0.5}) {
    stripes::Image image = line_image({0, sigma, 200});
    for (int row = 0; row < kRows; ++row)
      image.add(row, {line(row), 5, 20});  // a glow about it
    image.add_noise(1.5, 3);
    const Errors found = errors(detect(image));
    EXPECT_EQ(found.missing, 0) << sigma;
    EXPECT_LT(found.worst, 0.8) << sigma;
  }
}

TEST_P(EachDetector, GivesTheWidthAtHalfOfTheHeight) {
  for (const double sigma : {1.0, 2.0, 4.0}) {
    stripes::Image image = line_image({0, sigma, 150});
    for (const float width : detect(image).width)
      EXPECT_NEAR(width, 2.355 * std::hypot(sigma, std::sqrt(1 / 12.0)), 0.12 * sigma + 0.15);
  }
}

TEST_P(EachDetector, TakesExtremeImages) {
  for (const std::uint8_t grey : {std::uint8_t{0}, std::uint8_t{128}, std::uint8_t{255}}) {
    for (const int columns : {1, 2, 3, 127, 128, 129, 65535}) {
      stripes::Image image(columns, 3, grey);
      EXPECT_EQ(peaks(detect(image)), 0) << columns << " columns of " << int{grey};
    }
  }
  stripes::Image wide(65535, 2, 5);
  wide.add(0, {65000.25, 1.5, 200});
  wide.add(1, {3.0, 0.7, 200});
  const PeakProfile profile = detect(wide);
  EXPECT_NEAR(profile.position[0], 65000.25, 0.05);
  EXPECT_NEAR(profile.position[1], 3.0, 0.05);
}

TEST_P(EachDetector, KeepsPeaksInsideTheImageWhateverThePixels) {
  std::mt19937 engine(6);
  for (int i = 0; i < 3000; ++i) {
    const int columns = 1 + static_cast<int>(engine() % 200);
    const int rows = 1 + static_cast<int>(engine() % 5);
    stripes::Image image(columns, rows, 0);
    const int levels = 2 + static_cast<int>(engine() % 255);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        image.at(row, column) = engine() % levels;
    DetectorSettings settings;
    settings.trigger_level = static_cast<int>(engine() % 257) - 1;
    settings.permanence = 1 + static_cast<int>(engine() % 64);
    settings.window = static_cast<int>(engine() % 256);
    const PeakProfile profile = detect(image, settings);
    for (int row = 0; row < rows; ++row) {
      if (std::isnan(profile.position[row])) continue;
      ASSERT_GE(profile.position[row], 0);
      ASSERT_LE(profile.position[row], columns - 1);
      ASSERT_GT(profile.width[row], 0);
      ASSERT_LE(profile.width[row], columns);
    }
  }
}
