// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/figures/view_table.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace scanner_views {

const std::vector<std::string>& yardsticks() {
  static const std::vector<std::string> names = {"thesis' general method (never refuses)",
                                                 "PCL: FPFH, prerejective RANSAC, ICP with scale",
                                                 "Open3D: FPFH, RANSAC, ICP with scale"};
  return names;
}

std::string cell_of(double value, int digits) {
  return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, digits);
}

std::string percent_of(std::size_t part, std::size_t whole) {
  return whole == 0 ? "" : cell_of(100 * static_cast<double>(part) / static_cast<double>(whole), 1);
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
    const Expectations& as = errors.expectations;
    std::printf("| %.3f | %.3f | %.2f | %.2f | %.1f | %s, %s, %s ", 1e3 * errors.normal,
                1e3 * errors.tangential, errors.angle * kDegrees, 1e3 * errors.worst_position,
                errors.worst_angle * kDegrees, percent_of(as.normal, as.waypoints).c_str(),
                percent_of(as.along, as.waypoints).c_str(),
                percent_of(as.angle, as.with_angle).c_str());
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

}  // namespace scanner_views
