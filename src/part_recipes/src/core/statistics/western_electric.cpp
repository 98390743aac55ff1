// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "statistics/western_electric.h"

#include <algorithm>
#include <array>

namespace part_recipes {
namespace {

/// A number of the latest values is farther from the mean than a number of sigmas, on one side.
struct Rule {
  int number;
  std::size_t needed, of;
  double sigmas;
};

// Western Electric, Statistical Quality Control Handbook, 1956
constexpr std::array<Rule, 4> kRules = {{{1, 1, 1, 3}, {2, 2, 3, 2}, {3, 4, 5, 1}, {4, 8, 8, 0}}};

}  // namespace

std::vector<RuleBreak> western_electric(const std::vector<double>& values, double mean,
                                        double sigma) {
  std::vector<RuleBreak> breaks;
  for (std::size_t at = 0; at < values.size(); ++at) {
    for (const Rule& rule : kRules) {
      for (const double side : {1.0, -1.0}) {
        const auto is_beyond = [&](std::size_t i) {
          return side * (values[i] - mean) > rule.sigmas * sigma;
        };
        if (!is_beyond(at)) continue;
        RuleBreak found{rule.number, at, {}};
        for (std::size_t i = at + 1 - std::min(rule.of, at + 1); i <= at; ++i) {
          if (is_beyond(i)) found.points.push_back(i);
        }
        if (found.points.size() >= rule.needed) breaks.push_back(std::move(found));
      }
    }
  }
  return breaks;
}

}  // namespace part_recipes
