// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace part_recipes {

/// From one value to another, in the same unit.
struct Interval {
  double lower = 0, upper = 0;
};

/// How well a process keeps within a tolerance.
struct Capability {
  std::size_t first = 0;          //!< index of its first value
  std::size_t count = 0;          //!< of values, from that one to the last
  double mean = 0;                //!< in the values' unit
  double standard_deviation = 0;  //!< of the sample, with count - 1
  double cp = 0;                  //!< width of the tolerance / 6 standard deviations
  Interval cp_interval;           //!< that holds the true one in 95 % of all samples
  double cpk = 0;                 //!< distance of the mean from the nearer limit / 3 of them
  Interval cpk_interval;          //!< 95 %
};

/// Why there is no capability.
enum class NoCapability {
  kNoTolerance,       //!< there are no limits to keep
  kToleranceChanged,  //!< not all values had the same limits
  kTooFewValues,      //!< fewer than kCapabilityValues
  kNotInControl,      //!< fewer than kCapabilityValues since a rule was broken
  kNoSpread           //!< all values are the same
};

/// Number of values needed: with fewer the interval says nothing. Montgomery, Introduction to
/// Statistical Quality Control: 20 to 25 for control limits.
constexpr std::size_t kCapabilityValues = 25;

/// The reason as a word for files, and in words for people.
std::string to_string(NoCapability reason);
std::string in_words(NoCapability reason);

/// Capability from figures of a sample, whether or not the process is in control. Interval of Cp:
/// exact for normal values, from the chi-square distribution with count - 1 degrees of freedom
/// (NIST e-Handbook 6.1.6). Interval of Cpk: A. F. Bissell, How reliable is your capability index?,
/// Applied Statistics 39 (1990) 331-340.
/// @param count 2 or more
/// @param standard_deviation above 0
Capability capability_of(std::size_t count, double mean, double standard_deviation,
                         const Interval& tolerance);

/// Capability of a process while it is in control: of the values since it last broke one of the
/// rules of western_electric(), by the chart of all values.
/// @param values in the order in which they arose
/// @param tolerance none: kNoTolerance
std::variant<Capability, NoCapability> capability(const std::vector<double>& values,
                                                  const std::optional<Interval>& tolerance);

}  // namespace part_recipes
