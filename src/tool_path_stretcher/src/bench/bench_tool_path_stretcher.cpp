// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "cases/case_list.h"
#include "cases/thesis_method.h"
#include "tool_path_stretcher/stretcher.h"

namespace {

using namespace tool_path_stretcher;

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

/// What all cases came to.
struct Sums {
  std::size_t cases = 0;
  std::size_t right = 0;
  std::size_t wrong_accepted = 0;
  std::size_t within_goals = 0;
  std::size_t accepted = 0;
  std::size_t thesis_within_5_mm = 0;
  std::vector<double> seconds;
  std::vector<double> thesis_seconds;
};

bool within_goals(const cases::PathError& error) {
  return error.normal <= 1e-4 && error.tangential <= 5e-4 && error.orientation <= M_PI / 180;
}

void run(const cases::Case& each, Sums& sums) {
  const StretchParameters parameters;
  const Points reference =
      cases::scan(each.reference, cases::none(), Similarity(), each.reference_scan);
  const Points object =
      cases::scan(each.object, each.deformation, each.similarity, each.object_scan);
  const ToolPath& path = each.reference.path;
  const ToolPath truth = cases::truth(path, each.deformation, each.similarity);
  StretchResult ours;
  const double seconds = seconds_of([&] {
    ours = stretch(surface_from_cloud(reference, parameters.leaf, "reference"),
                   surface_from_cloud(object, parameters.leaf, "object"), path, parameters);
  });
  ToolPath thesis;
  const double thesis_seconds =
      seconds_of([&] { thesis = cases::thesis_method(reference, object, path); });
  const cases::PathError thesis_error = cases::error_of(thesis, truth, {});

  const bool right = ours.verdict.reason == each.expected;
  ++sums.cases;
  sums.right += right;
  sums.wrong_accepted += ours.verdict.accepted() && !right;
  sums.thesis_within_5_mm += thesis_error.worst < 0.005;
  sums.seconds.push_back(seconds);
  sums.thesis_seconds.push_back(thesis_seconds);
  std::printf("| %s | %s%s ", each.name.c_str(), to_string(ours.verdict.reason).c_str(),
              right ? "" : " (WRONG)");
  if (ours.verdict.accepted()) {
    const cases::PathError error = cases::error_of(ours.path, truth, {});
    ++sums.accepted;
    sums.within_goals += within_goals(error);
    std::printf("| %.3f | %.3f | %.2f ", 1e3 * error.normal, 1e3 * error.tangential,
                error.orientation * 180 / M_PI);
  } else {
    std::printf("| | | ");
  }
  std::printf("| %.2f | %.3f | %.3f | %.2f |\n", seconds, 1e3 * thesis_error.normal,
              1e3 * thesis_error.tangential, thesis_seconds);
  std::fflush(stdout);
}

}  // namespace

int main() {
  const char* data = std::getenv("SCAN_CELL_DATA");
  const std::vector<cases::Case> all = cases::all_cases(data == nullptr ? "" : data);
  if (data == nullptr) {
    std::printf("Without the real parts: SCAN_CELL_DATA names no folder that holds parts/\n");
  }
  std::printf(
      "Path errors RMS against exact truth: normal mm, tangential mm, orientation deg; the last\n"
      "three columns are the thesis' general method with PCL, which never refuses.\n\n"
      "| case | verdict | normal | tangential | orientation | s | normal | tangential | s |\n"
      "|---|---|---|---|---|---|---|---|---|\n");
  Sums sums;
  for (const cases::Case& each : all)
    run(each, sums);
  std::printf("\nverdicts right: %zu of %zu; wrong paths accepted: %zu\n", sums.right, sums.cases,
              sums.wrong_accepted);
  std::printf("accepted paths within 0.1 mm normal, 0.5 mm tangential, 1 degree: %zu of %zu\n",
              sums.within_goals, sums.accepted);
  std::printf("thesis' method: within 5 mm everywhere in %zu of %zu\n", sums.thesis_within_5_mm,
              sums.cases);
  const double median = middle_of(sums.seconds);
  const double thesis_median = middle_of(sums.thesis_seconds);
  std::printf("median time: %.2f s, thesis' method %.2f s, ratio %.2f\n", median, thesis_median,
              thesis_median / median);
  return 0;
}
