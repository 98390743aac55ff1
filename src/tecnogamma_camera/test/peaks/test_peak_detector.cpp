// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "peaks/stripes.h"
#include "scan_cell_common/errors/errors.h"
#include "tecnogamma_camera/peak_detector.h"

using tecnogamma_camera::Choice;
using tecnogamma_camera::DetectorSettings;
using tecnogamma_camera::GreyImage;
using tecnogamma_camera::ImageView8;
using tecnogamma_camera::make_detector;
using tecnogamma_camera::PeakDetector;
using tecnogamma_camera::PeakProfile;

namespace {

DetectorSettings settings(int trigger_level, int permanence, Choice choice = Choice::kBrightest) {
  DetectorSettings result;
  result.trigger_level = trigger_level;
  result.permanence = permanence;
  result.choice = choice;
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
    const int columns = static_cast<int>(pixels_.size());
    PeakProfile profile;
    detector.detect(ImageView8{pixels_.data(), columns, 1, columns, 0, 0}, profile);
    return profile;
  }

 private:
  std::vector<std::uint8_t> pixels_;
};

PeakProfile threshold(const std::string& picture, const DetectorSettings& with) {
  return Row(picture).detect(*make_detector("threshold", with));
}

float threshold_position(const std::string& picture, int permanence,
                         Choice choice = Choice::kBrightest) {
  return threshold(picture, settings(100, permanence, choice)).position[0];
}

}  // namespace

TEST(ThresholdDetector, PutsThePeakInTheMiddleBetweenTheEdges) {
  const PeakProfile profile = threshold("....####.....", settings(105, 2));
  EXPECT_EQ(profile.position[0], 5.5F);
  EXPECT_EQ(profile.width[0], 4.0F);  // 105 is half way up each edge
  EXPECT_EQ(profile.intensity[0], 200.0F);
  EXPECT_EQ(threshold_position("....#####....", 2), 6.0F);
}

TEST(ThresholdDetector, InterpolatesTheEdgesBetweenColumns) {
  const std::uint8_t pixels[] = {0, 0, 80, 200, 200, 40, 0, 0};
  PeakProfile profile;
  make_detector("threshold", settings(60, 2))->detect(ImageView8{pixels, 8, 1, 8, 0, 0}, profile);
  const double rise = 1 + 60.0 / 80, fall = 4 + 140.0 / 160;
  EXPECT_FLOAT_EQ(profile.position[0], static_cast<float>(0.5 * (rise + fall)));
  EXPECT_FLOAT_EQ(profile.width[0], static_cast<float>(fall - rise));
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
  EXPECT_TRUE(std::isnan(threshold("...##...", settings(200, 2)).position[0]));
  EXPECT_EQ(threshold("...##...", settings(199, 2)).position[0], 3.5F);
  EXPECT_TRUE(std::isnan(threshold("..++++..", settings(255, 1)).position[0]));
  EXPECT_TRUE(std::isnan(threshold("..++++..", settings(300, 1)).position[0]));  // not 300 - 256
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

TEST(PeakDetector, TakesTheFirstOrTheLastSpotWhereThatIsChosen) {
  EXPECT_EQ(threshold_position("..##..+++++..##..", 2, Choice::kFirst), 2.5F);
  EXPECT_EQ(threshold_position("..##..+++++..##..", 2, Choice::kLast), 13.5F);
  EXPECT_EQ(threshold_position("..##..+++++..##..", 2, Choice::kBrightest), 8.0F);
  EXPECT_EQ(threshold_position("..#..+++++..#....", 2, Choice::kFirst), 7.0F);  // too short an edge
}

TEST(ThresholdDetector, PassesOverSpotsThatAreTooWide) {
  DetectorSettings narrow = settings(105, 2);
  narrow.max_width = 4;
  EXPECT_EQ(threshold("..###....+++++...", narrow).position[0], 3.0F);
  EXPECT_EQ(threshold("..####....+++++...", narrow).position[0], 3.5F) << "4 is not above 4";
  EXPECT_EQ(threshold("#######...###....", narrow).position[0], 11.0F) << "also if it is cut";
  EXPECT_TRUE(std::isnan(threshold("###...##.....", narrow).position[0])) << "cut, and may be it";
  EXPECT_TRUE(std::isnan(threshold("...#####.....", narrow).position[0]));
}

TEST(ThresholdDetector, DoesNotFallBackToAReflectionWhereTheLineIsCut) {
  EXPECT_TRUE(std::isnan(threshold_position("#####...##....", 2)));
  EXPECT_EQ(threshold_position("##...####....", 2), 6.5F);
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
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    stripes::Image picture(100, 3);
    for (int row = 0; row < 3; ++row) {
      picture.add(row, {20, 1.5, 180});
      picture.add(row, {80, 3, 250});
    }
    ImageView8 image = picture.view();
    image.columns = 50;
    PeakProfile profile;
    make_detector(name, settings(60, 2))->detect(image, profile);
    for (const float position : profile.position)
      EXPECT_NEAR(position, 20, 1e-3) << name;
  }
}

TEST(PeakDetector, HasNoPeakInADarkAnEmptyOrATinyImage) {
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    const auto detector = make_detector(name, {});
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
  EXPECT_EQ(refused(settings(65536, 2)), "trigger_level");
  EXPECT_EQ(refused(settings(-2, 2)), "trigger_level");
  EXPECT_EQ(refused(settings(60, 0)), "permanence");
  DetectorSettings window;
  window.window = 256;
  EXPECT_EQ(refused(window), "window");
  DetectorSettings width;
  for (const double most : {-1.0, 70000.0, std::nan("")}) {
    width.max_width = most;
    EXPECT_EQ(refused(width), "max_width") << most;
  }
  EXPECT_THROW(make_detector("parabola", {}), scan_cell_common::InvalidParameter);
}

TEST(PeakDetector, TakesGreyValuesOfMoreThanEightBitsAsTheyAre) {
  for (const std::string& name : tecnogamma_camera::detector_names()) {
    for (const int bits : {10, 12, 16}) {
      const double most = (1 << bits) - 1;
      stripes::Image picture(80, 1, 0.05 * most);
      picture.add(0, {30.3, 1.5, 0.7 * most});
      for (const int level : {tecnogamma_camera::kAutomaticLevel, static_cast<int>(0.4 * most)}) {
        PeakProfile profile;
        make_detector(name, settings(level, 2))->detect(picture.view16(bits), profile);
        EXPECT_NEAR(profile.position[0], 30.3, 0.02) << name << " " << bits;
        EXPECT_NEAR(profile.intensity[0], 0.75 * most, 0.06 * most) << name << " " << bits;
      }
    }
  }
}
