// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "scanner_views/figures/view_table.h"

namespace scanner_views {
namespace {

double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? NAN : values[values.size() / 2];
}

/// Sums over the cases of one family, or of all.
struct Sums {
  std::size_t cases = 0, to_accept = 0;
  std::size_t right = 0, wrong = 0, needless = 0, rightly_refused = 0;
  double normal = 0, tangential = 0, angle = 0;  // squares over the right ones
  Expectations counts;                           // of the accepted ones
  std::vector<double> seconds;
};

void add(const CaseResult& result, Sums& sums) {
  const Outcome& ours = result.ours;
  ++sums.cases;
  sums.to_accept += result.to_accept;
  sums.right += ours.worth == Worth::kRight;
  sums.wrong += ours.worth == Worth::kWrong;
  sums.needless += ours.worth == Worth::kRefusedNeedlessly;
  sums.rightly_refused += ours.worth == Worth::kRefusedRightly;
  sums.seconds.push_back(ours.answer.seconds);
  sums.counts += ours.errors.expectations;
  if (ours.worth != Worth::kRight) return;
  sums.normal += std::pow(ours.errors.normal, 2);
  sums.tangential += std::pow(ours.errors.tangential, 2);
  sums.angle += std::pow(ours.errors.angle, 2);
}

void print(const std::string& family, const Sums& sums) {
  const auto rms = [&sums](double squares) {
    return std::sqrt(squares / static_cast<double>(sums.right));
  };
  std::printf("| %s | %zu of %zu | %zu | %zu | %zu of %zu |", family.c_str(), sums.right,
              sums.to_accept, sums.needless, sums.wrong, sums.rightly_refused,
              sums.cases - sums.to_accept);
  const Expectations& counts = sums.counts;
  for (const std::string& cell :
       {cell_of(1e3 * rms(sums.normal), 3), cell_of(1e3 * rms(sums.tangential), 3),
        cell_of(rms(sums.angle) * kDegrees, 2), percent_of(counts.normal, counts.waypoints),
        percent_of(counts.along, counts.waypoints), percent_of(counts.angle, counts.with_angle),
        percent_of(counts.known_along, counts.truly_along), cell_of(middle_of(sums.seconds), 2)})
    std::printf(" %s |", cell.c_str());
  std::printf("\n");
}

/// Prints one method over the cases in which the yardsticks ran.
template <class OutcomeOf>
void print_method(const std::string& name, const std::vector<CaseResult>& results,
                  const OutcomeOf& outcome_of) {
  constexpr double kNear = 0.001;  // [m]
  std::size_t to_accept = 0, near = 0, right = 0, wrong = 0;
  std::vector<double> seconds;
  for (const CaseResult& result : results) {
    if (result.others.empty()) continue;
    const Outcome& outcome = outcome_of(result);
    if (outcome.answer.verdict == kNotInstalled) {
      std::printf("| %s | %s | | | |\n", name.c_str(), kNotInstalled);
      return;
    }
    to_accept += result.to_accept;
    near += outcome.errors.waypoints > 0 && outcome.errors.position < kNear;
    right += outcome.worth == Worth::kRight;
    wrong += outcome.worth == Worth::kWrong;
    seconds.push_back(outcome.answer.seconds);
  }
  std::printf("| %s | %zu of %zu | %zu | %zu | %s |\n", name.c_str(), near, to_accept, right, wrong,
              cell_of(middle_of(seconds), 2).c_str());
}

void print_methods(const std::vector<CaseResult>& results) {
  const auto count = std::count_if(results.begin(), results.end(),
                                   [](const CaseResult& result) { return !result.others.empty(); });
  if (count == 0) return;
  std::printf(
      "\nThe %td cases in which the yardsticks were run:\n\n"
      "| method | within 1 mm RMS | accepted and right | accepted and wrong | median s |\n"
      "|---|---|---|---|---|\n",
      count);
  print_method("here", results,
               [](const CaseResult& result) -> const Outcome& { return result.ours; });
  for (std::size_t i = 0; i < yardsticks().size(); ++i) {
    print_method(yardsticks()[i], results,
                 [i](const CaseResult& result) -> const Outcome& { return result.others.at(i); });
  }
}

}  // namespace

void print_sums(const std::vector<CaseResult>& results) {
  if (results.empty()) return;
  std::printf(
      "\n| family | right | refused needlessly | wrong | rightly refused | normal | tangential | "
      "angle | normal as expected %% | tangential %% | angle %% | known along %% | median s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  std::vector<std::string> families;
  Sums all;
  for (const CaseResult& result : results) {
    if (std::find(families.begin(), families.end(), result.family) == families.end())
      families.push_back(result.family);
    add(result, all);
  }
  for (const std::string& family : families) {
    Sums sums;
    for (const CaseResult& result : results) {
      if (result.family == family) add(result, sums);
    }
    print(family, sums);
  }
  print("all", all);
  print_methods(results);
  std::printf("\n");
  for (const CaseResult& result : results) {
    const bool as_wanted =
        result.ours.worth == Worth::kRight || result.ours.worth == Worth::kRefusedRightly;
    if (!as_wanted)
      std::printf("- %s: %s %s\n", result.name.c_str(), to_string(result.ours.worth).c_str(),
                  result.ours.answer.message.c_str());
  }
}

}  // namespace scanner_views
