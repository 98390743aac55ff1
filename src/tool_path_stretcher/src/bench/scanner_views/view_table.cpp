// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/view_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scanner_views {
namespace {

constexpr double kDegree = M_PI / 180;

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? NAN : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? NAN : values[values.size() / 2];
}

/// Of the cases of one family, or of all.
struct Sums {
  std::size_t cases = 0, to_accept = 0;
  std::size_t right = 0, wrong = 0, needless = 0, rightly_refused = 0;
  double normal = 0, tangential = 0, angle = 0;  // squares of those that are right
  Errors counts;                                 // of those that are accepted
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
  Errors& counts = sums.counts;
  counts.with_quality += ours.errors.with_quality;
  counts.normal_as_expected += ours.errors.normal_as_expected;
  counts.along_as_expected += ours.errors.along_as_expected;
  counts.truly_along += ours.errors.truly_along;
  counts.known_along += ours.errors.known_along;
  if (ours.worth != Worth::kRight) return;
  sums.normal += ours.errors.normal * ours.errors.normal;
  sums.tangential += ours.errors.tangential * ours.errors.tangential;
  sums.angle += ours.errors.angle * ours.errors.angle;
}

void print(const std::string& family, const Sums& sums) {
  const auto rms = [&sums](double squares) {
    return std::sqrt(squares / static_cast<double>(sums.right));
  };
  const Errors& counts = sums.counts;
  std::printf(
      "| %s | %zu of %zu | %zu | %zu | %zu of %zu | %.3f | %.3f | %.2f | %.1f | %.1f | %.1f | %.2f "
      "|\n",
      family.c_str(), sums.right, sums.to_accept, sums.needless, sums.wrong, sums.rightly_refused,
      sums.cases - sums.to_accept, 1e3 * rms(sums.normal), 1e3 * rms(sums.tangential),
      rms(sums.angle) / kDegree, percent(counts.normal_as_expected, counts.with_quality),
      percent(counts.along_as_expected, counts.with_quality),
      percent(counts.known_along, counts.truly_along), middle_of(sums.seconds));
}

void print_others(const std::vector<CaseResult>& results) {
  constexpr double kNear = 0.001;  // [m]
  std::printf(
      "\n| method | within 1 mm RMS | accepted and right | accepted and wrong | median s |\n"
      "|---|---|---|---|---|\n");
  std::size_t to_accept = 0;
  for (const CaseResult& result : results)
    to_accept += result.to_accept;
  const auto line = [&](const std::string& name, const auto& outcome_in) {
    std::size_t near = 0, right = 0, wrong = 0;
    std::vector<double> seconds;
    for (const CaseResult& result : results) {
      const Outcome& outcome = outcome_in(result);
      const bool accepted = outcome.worth == Worth::kRight || outcome.worth == Worth::kWrong;
      near += accepted && result.to_accept && outcome.errors.position < kNear;
      right += outcome.worth == Worth::kRight;
      wrong += outcome.worth == Worth::kWrong;
      seconds.push_back(outcome.answer.seconds);
    }
    std::printf("| %s | %zu of %zu | %zu | %zu | %.2f |\n", name.c_str(), near, to_accept, right,
                wrong, middle_of(seconds));
  };
  line("here", [](const CaseResult& result) -> const Outcome& { return result.ours; });
  for (std::size_t i = 0; i < yardsticks().size(); ++i) {
    if (results.front().others.at(i).answer.verdict == kNotInstalled) {
      std::printf("| %s | %s | | | |\n", yardsticks()[i].c_str(), kNotInstalled);
      continue;
    }
    line(yardsticks()[i],
         [i](const CaseResult& result) -> const Outcome& { return result.others.at(i); });
  }
}

}  // namespace

const std::vector<std::string>& yardsticks() {
  static const std::vector<std::string> names = {"thesis' general method (never refuses)",
                                                 "PCL: FPFH, prerejective RANSAC, ICP with scale",
                                                 "Open3D: FPFH, RANSAC, ICP with scale"};
  return names;
}

void print_head(bool with_others) {
  std::printf(
      "| case | verdict | is | normal | tangential | angle | worst | turned | as expected | "
      "points | s |%s\n|---|---|---|---|---|---|---|---|---|---|---|%s\n",
      with_others ? " thesis | PCL | Open3D |" : "", with_others ? "---|---|---|" : "");
}

void print_line(const CaseResult& result) {
  const Outcome& ours = result.ours;
  std::printf("| %s | %s | %s ", result.name.c_str(), ours.answer.verdict.c_str(),
              to_string(ours.worth).c_str());
  const Errors& errors = ours.errors;
  if (errors.waypoints > 0) {
    std::printf("| %.3f | %.3f | %.2f | %.2f | %.1f | %.0f, %.0f ", 1e3 * errors.normal,
                1e3 * errors.tangential, errors.angle / kDegree, 1e3 * errors.worst_position,
                errors.worst_angle / kDegree,
                percent(errors.normal_as_expected, errors.with_quality),
                percent(errors.along_as_expected, errors.with_quality));
  } else {
    std::printf("| | | | | | ");
  }
  std::printf("| %zu | %.2f |", result.points, ours.answer.seconds);
  for (const Outcome& other : result.others) {
    if (other.errors.waypoints > 0) {
      std::printf(" %.2f |", 1e3 * other.errors.position);
    } else {
      std::printf(" %s |",
                  other.worth == Worth::kWrong ? "accepted" : other.answer.verdict.c_str());
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

void print_sums(const std::vector<CaseResult>& results, bool with_others) {
  if (results.empty()) return;
  std::printf(
      "\n| family | right | refused needlessly | wrong | rightly refused | normal | tangential | "
      "angle | normal as expected %% | tangential %% | known along %% | median s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
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
  if (with_others) print_others(results);
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
