// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "peaks/lit_pixels.h"
#include "tecnogamma_camera/peak_detector.h"

using tecnogamma_camera::LitPixels;

namespace {

template <class Pixel>
std::vector<Pixel> random_row(int columns, int most, std::mt19937& engine) {
  std::uniform_int_distribution<int> grey(0, most);
  std::vector<Pixel> row;
  // Stretches in which few or many pixels are lit.
  while (static_cast<int>(row.size()) < columns) {
    const int ceiling = grey(engine);
    for (int i = 0; i < 50; ++i)
      row.push_back(static_cast<Pixel>(std::min(grey(engine), ceiling)));
  }
  row.resize(static_cast<std::size_t>(columns));
  return row;
}

/// Answers every question by looking at the pixels one by one.
template <class Pixel>
void expect_the_same_as_one_by_one(const std::vector<Pixel>& row,
                                   const std::vector<Pixel>& levels) {
  const int columns = static_cast<int>(row.size());
  const auto is_lit = [&](int column) {
    return row[column] > levels[column / tecnogamma_camera::kLevelColumns];
  };
  LitPixels lit;
  lit.mark(row.data(), columns, levels);
  int next_lit = columns, next_dark = columns;
  for (int from = columns - 1; from >= 0; --from) {
    (is_lit(from) ? next_lit : next_dark) = from;
    ASSERT_EQ(lit.next_lit(from), next_lit) << from << " of " << columns;
    if (!is_lit(from)) continue;
    ASSERT_EQ(lit.next_dark(from), next_dark) << from << " of " << columns;
  }
  ASSERT_EQ(lit.next_lit(columns), columns);
}

template <class Pixel>
void try_rows(int most, unsigned seed) {
  std::mt19937 engine(seed);
  for (const int columns : {1, 2, 63, 64, 65, 127, 128, 129, 191, 192, 193, 640, 1696, 65535}) {
    for (int i = 0; i < 20; ++i) {
      const auto levels = random_row<Pixel>(tecnogamma_camera::levels_of(columns), most, engine);
      expect_the_same_as_one_by_one(random_row<Pixel>(columns, most, engine), levels);
    }
  }
}

/// The rule of PeakDetector for a trigger level, as a state machine that reads pixel by pixel.
/// @return the spot's edges; {0, 0} if there is none or it is cut
std::pair<int, int> spot_by_rule(const std::vector<std::uint8_t>& row, int level, int permanence) {
  const int columns = static_cast<int>(row.size());
  struct Found {
    int rise, fall;
    long light;
    bool cut;
  };
  std::vector<Found> spots;
  int lit = 0, dark = 0, rise = -1;
  for (int column = 0; column < columns; ++column) {
    const bool is_lit = row[column] > level;
    lit = is_lit ? lit + 1 : 0;
    dark = is_lit ? 0 : dark + 1;
    if (rise < 0 && lit == permanence) rise = column - permanence + 1;
    if (rise >= 0 && dark == permanence) {
      spots.push_back({rise, column - permanence + 1, 0, rise == 0});
      rise = -1;
    }
  }
  if (rise >= 0) spots.push_back({rise, columns - dark, 0, true});
  const Found* best = nullptr;
  for (Found& spot : spots) {
    for (int i = spot.rise; i < spot.fall; ++i)
      spot.light += row[i] - level;
    if (!best || spot.light > best->light) best = &spot;
  }
  if (!best || best->cut) return {0, 0};
  return {best->rise, best->fall};
}

double crossing(const std::vector<std::uint8_t>& row, int lit, int dark, int level) {
  const double share = static_cast<double>(row[lit] - level) / (row[lit] - row[dark]);
  return lit + share * (dark - lit);
}

}  // namespace

TEST(LitPixels, AreTheSameAsWhenLookedAtOneByOne) {
  try_rows<std::uint8_t>(255, 1);
  try_rows<std::uint16_t>(4095, 2);
  try_rows<std::uint16_t>(65535, 3);
}

TEST(ThresholdDetector, KeepsItsRuleInRandomRows) {
  std::mt19937 engine(4);
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const int columns = 1 + static_cast<int>(engine() % 300);
    auto row = random_row<std::uint8_t>(columns, 255, engine);
    tecnogamma_camera::DetectorSettings settings;
    settings.trigger_level = static_cast<int>(engine() % 256);
    settings.permanence = 1 + static_cast<int>(engine() % 4);
    const auto edges = spot_by_rule(row, settings.trigger_level, settings.permanence);
    tecnogamma_camera::PeakProfile profile;
    make_detector("threshold", settings)
        ->detect(tecnogamma_camera::ImageView8{row.data(), columns, 1, columns, 0, 0}, profile);
    ASSERT_EQ(std::isnan(profile.position[0]), edges.second == 0) << "row " << i;
    if (edges.second == 0) continue;
    ++found;
    const double rise = crossing(row, edges.first, edges.first - 1, settings.trigger_level);
    const double fall = crossing(row, edges.second - 1, edges.second, settings.trigger_level);
    ASSERT_NEAR(profile.position[0], 0.5 * (rise + fall), 1e-4) << "row " << i;
    ASSERT_NEAR(profile.width[0], fall - rise, 1e-4) << "row " << i;
  }
  EXPECT_GT(found, 5000);
}
