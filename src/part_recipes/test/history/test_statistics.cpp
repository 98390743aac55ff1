// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "statistics/capability.h"
#include "statistics/individuals_chart.h"
#include "statistics/western_electric.h"

namespace part_recipes {
namespace {

using Indices = std::vector<std::size_t>;

/// The breaks of one rule, each as the values that break it.
std::vector<Indices> breaks_of(int rule, const std::vector<double>& values) {
  std::vector<Indices> found;
  for (const RuleBreak& broken : western_electric(values, 0, 1)) {
    EXPECT_EQ(broken.points.back(), broken.at);
    if (broken.rule == rule) found.push_back(broken.points);
  }
  return found;
}

// NIST/SEMATECH e-Handbook of Statistical Methods, 6.3.2.2: flow rates of ten batches
TEST(IndividualsChart, HasTheLimitsOfTheNistFlowRates) {
  const std::vector<double> flow = {49.6, 47.6, 49.9, 51.3, 47.8, 51.2, 52.6, 52.4, 53.6, 52.1};
  const auto chart = individuals_chart(flow);
  ASSERT_TRUE(chart);
  EXPECT_NEAR(chart->mean, 50.81, 1e-9);
  EXPECT_NEAR(chart->moving_range_mean, 1.8778, 5e-5);
  EXPECT_NEAR(chart->upper, 55.8041, 5e-5);
  EXPECT_NEAR(chart->lower, 45.8159, 5e-5);
  EXPECT_TRUE(chart->wide_ranges.empty());
  EXPECT_TRUE(western_electric(flow, chart->mean, chart->sigma).empty());  // "in control"
}

// Montgomery, Introduction to Statistical Quality Control: viscosity of aircraft primer paint
TEST(IndividualsChart, HasTheLimitsOfMontgomerysPaint) {
  const auto chart = individuals_chart({33.75, 33.05, 34.00, 33.81, 33.46, 34.02, 33.68, 33.27,
                                        33.49, 33.20, 33.62, 33.00, 33.54, 33.12, 33.84});
  ASSERT_TRUE(chart);
  EXPECT_NEAR(chart->mean, 33.52, 5e-3);
  EXPECT_NEAR(chart->moving_range_mean, 0.48, 5e-3);
  EXPECT_NEAR(chart->upper, 34.80, 5e-3);
  EXPECT_NEAR(chart->lower, 32.24, 5e-3);
  EXPECT_NEAR(chart->moving_range_upper, 1.57, 5e-3);
}

TEST(IndividualsChart, TellsAJumpAsAWideRange) {
  std::vector<double> values(20);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (i < 10 ? 0.0 : 8.0) + (i % 2 == 0 ? 0.0 : 1.0);
  EXPECT_EQ(individuals_chart(values)->wide_ranges, Indices{10});
}

TEST(IndividualsChart, OfFewerThanTwoValuesIsNone) {
  EXPECT_FALSE(individuals_chart({}));
  EXPECT_FALSE(individuals_chart({1}));
  EXPECT_TRUE(individuals_chart({1, 2}));
}

TEST(IndividualsChart, OfEqualValuesHasNoSpreadAndBreaksNoRule) {
  const std::vector<double> values(30, 0.1);  // whose plain sum is not 3
  const auto chart = individuals_chart(values);
  EXPECT_EQ(chart->mean, 0.1);
  EXPECT_EQ(chart->sigma, 0);
  EXPECT_TRUE(western_electric(values, chart->mean, chart->sigma).empty());
}

TEST(WesternElectric, OneBeyondThreeSigmaBreaksRuleOne) {
  EXPECT_EQ(breaks_of(1, {0, 3.1, 0, -3.1}), (std::vector<Indices>{{1}, {3}}));
  EXPECT_TRUE(breaks_of(1, {3.0, -3.0}).empty());
}

TEST(WesternElectric, TwoOfThreeBeyondTwoSigmaBreakRuleTwo) {
  EXPECT_EQ(breaks_of(2, {0, 2.1, 0, 2.5, 0}), (std::vector<Indices>{{1, 3}}));
  EXPECT_TRUE(breaks_of(2, {0, 2.1, 0, 0, 2.5}).empty());
  EXPECT_TRUE(breaks_of(2, {0, 2.1, -2.1, 0}).empty());  // on either side
}

TEST(WesternElectric, FourOfFiveBeyondOneSigmaBreakRuleThree) {
  EXPECT_EQ(breaks_of(3, {-1.1, -1.2, 0, -1.3, -1.4, 0}), (std::vector<Indices>{{0, 1, 3, 4}}));
  EXPECT_TRUE(breaks_of(3, {-1.1, -1.2, 0, 0, -1.3, -1.4}).empty());
}

TEST(WesternElectric, EightOnOneSideBreakRuleFour) {
  const std::vector<double> values = {-0.1, 0.1, 0.2, 0.1, 0.2, 0.1, 0.2, 0.1, 0.2, 0.1, -0.1};
  EXPECT_EQ(breaks_of(4, values),
            (std::vector<Indices>{{1, 2, 3, 4, 5, 6, 7, 8}, {2, 3, 4, 5, 6, 7, 8, 9}}));
}

// Champ and Woodall, Exact Results for Shewhart Control Charts with Supplementary Runs Rules,
// Technometrics 29 (1987): a process in control runs 91.75 values until one of the four is broken
TEST(WesternElectric, SoundsFalseAlarmsAsOftenAsPublished) {
  constexpr int kSequences = 2000;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double sum = 0;
  for (int i = 0; i < kSequences; ++i) {
    std::vector<double> values(1500);  // 1 of 10 million sequences breaks none
    for (double& value : values)
      value = normal(random);
    sum += static_cast<double>(western_electric(values, 0, 1).at(0).at + 1);
  }
  EXPECT_NEAR(sum / kSequences, 91.75, 6);  // 3 standard errors
}

// NIST/SEMATECH e-Handbook of Statistical Methods, 6.1.6: limits 8 and 20, mean 16, deviation 2
TEST(Capability, IsThatOfTheNistExample) {
  const Capability found = capability_of(50, 16, 2, {8, 20});
  EXPECT_NEAR(found.cp, 1, 1e-12);
  EXPECT_NEAR(found.cpk, 0.6667, 5e-5);
}

// Montgomery, Introduction to Statistical Quality Control: n = 20, s = 1.75, limits 38 and 62. The
// book continues with the rounded 2.29, so s is chosen to give 2.29 here.
TEST(Capability, IntervalOfCpIsThatOfMontgomerysExample) {
  EXPECT_NEAR(capability_of(20, 50, 1.75, {38, 62}).cp, 2.29, 5e-3);
  const Capability found = capability_of(20, 50, 4 / 2.29, {38, 62});
  EXPECT_NEAR(found.cp_interval.lower, 1.57, 5e-3);
  EXPECT_NEAR(found.cp_interval.upper, 3.01, 5e-3);
}

// Bissell's formula by hand, with z = 1.959964: n = 20, Cpk = 1.33
TEST(Capability, IntervalOfCpkIsBissells) {
  const Capability found = capability_of(20, 0, 1, {-3 * 1.33, 3 * 1.33});
  const double half = 1.959964 * std::sqrt(1 / 180.0 + 1.33 * 1.33 / 38.0);
  EXPECT_NEAR(found.cpk_interval.lower, 1.33 - half, 1e-6);
  EXPECT_NEAR(found.cpk_interval.upper, 1.33 + half, 1e-6);
}

TEST(Capability, IntervalsHoldTheTrueValueIn95Percent) {
  constexpr int kSamples = 20000;
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.5, 1);
  const Interval tolerance = {-4, 4};
  const double true_cp = 8.0 / 6, true_cpk = 3.5 / 3;
  int cp_held = 0, cpk_held = 0;
  for (int i = 0; i < kSamples; ++i) {
    constexpr int kCount = 25;
    double sum = 0, squares = 0;
    for (int value = 0; value < kCount; ++value) {
      const double drawn = normal(random);
      sum += drawn;
      squares += drawn * drawn;
    }
    const double mean = sum / kCount;
    const double deviation = std::sqrt((squares - kCount * mean * mean) / (kCount - 1));
    const Capability found = capability_of(kCount, mean, deviation, tolerance);
    cp_held += found.cp_interval.lower <= true_cp && true_cp <= found.cp_interval.upper ? 1 : 0;
    cpk_held +=
        found.cpk_interval.lower <= true_cpk && true_cpk <= found.cpk_interval.upper ? 1 : 0;
  }
  EXPECT_NEAR(cp_held / double{kSamples}, 0.95, 0.005);   // 3 standard errors: exact
  EXPECT_NEAR(cpk_held / double{kSamples}, 0.95, 0.015);  // an approximation
}

/// In control: on either side in turn, within one sigma.
std::vector<double> calm(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = i % 2 == 0 ? -0.5 : 0.5;
  return values;
}

NoCapability reason(const std::vector<double>& values, const std::optional<Interval>& tolerance) {
  return std::get<NoCapability>(capability(values, tolerance));
}

TEST(Capability, IsThereFrom25ValuesInControlOn) {
  const auto found = std::get<Capability>(capability(calm(25), Interval{-2, 2}));
  EXPECT_EQ(found.count, 25u);
  EXPECT_NEAR(found.mean, -0.02, 1e-12);
  EXPECT_NEAR(found.standard_deviation, std::sqrt((25 * 0.25 - 25 * 0.0004) / 24), 1e-12);
  EXPECT_LT(found.cpk_interval.lower, found.cpk);
}

TEST(Capability, IsOfTheValuesSinceARuleWasBroken) {
  auto values = calm(60);
  values[20] = 9;
  const auto found = std::get<Capability>(capability(values, Interval{-2, 2}));
  EXPECT_EQ(found.first, 21u);
  EXPECT_EQ(found.count, 39u);
  EXPECT_NEAR(found.mean, 0.5 / 39, 1e-12);  // the first and the last of them are above
}

TEST(Capability, IsHadByMostProcessesInControlWithIntervalsThatHold) {
  constexpr int kSequences = 2000;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.5, 1);
  int had = 0, held = 0;
  for (int i = 0; i < kSequences; ++i) {
    std::vector<double> values(300);
    for (double& value : values)
      value = normal(random);
    const auto answer = capability(values, Interval{-4, 4});
    const auto* const found = std::get_if<Capability>(&answer);
    if (found == nullptr) continue;
    ++had;
    held += found->cp_interval.lower <= 8.0 / 6 && 8.0 / 6 <= found->cp_interval.upper ? 1 : 0;
  }
  EXPECT_GT(had / double{kSequences}, 0.7);
  EXPECT_NEAR(held / static_cast<double>(had), 0.94,
              0.02);  // the calm stretch spreads 4 % less than the whole
}

TEST(Capability, SaysWhyThereIsNone) {
  EXPECT_EQ(reason(calm(25), std::nullopt), NoCapability::kNoTolerance);
  EXPECT_EQ(reason(calm(25), Interval{0, 0}), NoCapability::kNoTolerance);
  EXPECT_EQ(reason(calm(24), Interval{-2, 2}), NoCapability::kTooFewValues);
  EXPECT_EQ(reason(std::vector<double>(25, 0.1), Interval{-2, 2}), NoCapability::kNoSpread);
  auto alarmed = calm(40);
  alarmed[20] = 5;
  EXPECT_EQ(reason(alarmed, Interval{-9, 9}), NoCapability::kNotInControl);
  for (const NoCapability each :
       {NoCapability::kNoTolerance, NoCapability::kToleranceChanged, NoCapability::kTooFewValues,
        NoCapability::kNotInControl, NoCapability::kNoSpread}) {
    EXPECT_FALSE(to_string(each).empty());
    EXPECT_FALSE(in_words(each).empty());
  }
}

}  // namespace
}  // namespace part_recipes
