// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "view/deviation_colours.h"

namespace part_recipes {
namespace {

using scan_cell_common::FieldedCloud;
using scan_cell_common::FieldType;

constexpr double kTolerance = 0.0005;
constexpr float kNotKnown = std::numeric_limits<float>::quiet_NaN();

/// Four columns in a row along x, 10 mm apart, of ten points each.
FieldedCloud columns(const std::vector<float>& deviations) {
  FieldedCloud cloud;
  for (const char* name : {"x", "y", "z", "deviation"})
    cloud.fields.push_back({name, FieldType::kFloat32, cloud.fields.size() * sizeof(float)});
  cloud.step = 4 * sizeof(float);
  for (std::size_t c = 0; c < deviations.size(); ++c) {
    for (int i = 0; i < 10; ++i) {
      const float values[] = {0.01F * static_cast<float>(c), 0, 1e-5F * static_cast<float>(i),
                              deviations[c]};
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(values);
      cloud.bytes.insert(cloud.bytes.end(), bytes, bytes + sizeof(values));
    }
  }
  return cloud;
}

std::uint32_t colour_at(const FieldedCloud& cloud, std::size_t point) {
  std::uint32_t rgb = 0;
  std::memcpy(&rgb, cloud.bytes.data() + point * cloud.step + cloud.fields.back().offset,
              sizeof(rgb));
  return rgb;
}

TEST(DeviationColours, AreFixedByTheTolerance) {
  const FieldedCloud cloud = coloured(columns({0, 0.001F, -0.001F, 0.004F, kNotKnown}), kTolerance);
  ASSERT_EQ(cloud.fields.back().name, "rgb");
  EXPECT_EQ(colour_at(cloud, 0), 0xf4f4f4U);   // the middle of the pages' scale
  EXPECT_EQ(colour_at(cloud, 10), 0xb04f00U);  // two tolerances: its end
  EXPECT_EQ(colour_at(cloud, 20), 0x0b4fa8U);
  EXPECT_EQ(colour_at(cloud, 30), 0xb04f00U);
  EXPECT_NE(colour_at(cloud, 40), 0xf4f4f4U);
  EXPECT_EQ(colour_at(coloured(columns({0.002F / 3}), 2 * kTolerance), 0), 0xfcc98fU)
      << "a third of the way to an end of 2 mm";
}

TEST(DeviationColours, OfACloudWithoutDeviationsAreOne) {
  FieldedCloud cloud = columns({0, 0.001F});
  cloud.fields.pop_back();
  const FieldedCloud shown = coloured(cloud, kTolerance);
  EXPECT_EQ(colour_at(shown, 0), colour_at(shown, 10));
  EXPECT_TRUE(deviation_marks(cloud, kTolerance).empty());
}

TEST(DeviationMarks, SayWhereMaterialIsMissingOrAdded) {
  const auto marks = deviation_marks(columns({0.0004F, 0.0008F, kNotKnown, -0.0006F}), kTolerance);
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_NEAR(marks[0].position.x(), 0.01, 1e-6);
  EXPECT_TRUE(marks[0].is_more);
  EXPECT_NEAR(marks[1].position.x(), 0.03, 1e-6);
  EXPECT_FALSE(marks[1].is_more);
}

}  // namespace
}  // namespace part_recipes
