// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "case_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stopwatch.h"
#include "tool_path_stretcher/stretcher.h"
#include "yardsticks/pcl_pipeline.h"
#include "yardsticks/thesis_method.h"

namespace bench {
namespace {

using namespace tool_path_stretcher;

constexpr double kGross = 0.005;  // [m] a path with a larger error anywhere is wrong

double middle_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

bool must_be_accepted(const cases::Case& each) {
  return each.expected == Reason::kAccepted;
}

/// The suite's results.
struct Ours {
  std::size_t right = 0;
  std::size_t wrong_accepted = 0;
  std::size_t gross = 0;
  std::size_t accepted = 0;
  std::size_t within_goals = 0;
  std::size_t within_goals_where_shown = 0;  // the tangential error only where reported as shown
  std::size_t waypoints = 0;
  std::size_t normal_as_expected = 0;
  std::size_t along_as_expected = 0;
  std::vector<double> seconds;
  std::vector<double> seconds_right;      // of the cases to be accepted
  std::vector<double> seconds_wrong;      // of another part
  std::vector<double> seconds_processor;  // of all
};

/// A yardstick's results.
struct Theirs {
  std::size_t within = 0;          // of cases to be accepted: converged, with no gross error
  std::size_t gross_accepted = 0;  // of those: converged, with a gross error
  std::size_t wrong_accepted = 0;  // of cases to be refused: converged
  std::vector<double> seconds;
};

struct Sums {
  std::size_t to_accept = 0;
  std::size_t to_refuse = 0;
  Ours ours;
  Theirs thesis;
  Theirs pcl;
};

bool within_goals(const cases::PathError& error) {
  return error.normal <= 1e-4 && error.tangential <= 5e-4 && error.orientation <= M_PI / 180;
}

/// Waypoints whose errors are within three times the expected ones.
struct AsExpected {
  std::size_t normal = 0;
  std::size_t along = 0;
};

AsExpected as_expected(const ToolPath& path, const ToolPath& truth,
                       const std::vector<WaypointQuality>& quality) {
  constexpr double kDeviations = 3;
  AsExpected count;
  for (const WaypointQuality& each : quality) {
    const Eigen::Isometry3d& should =
        truth.segments.at(each.segment).waypoints.at(each.waypoint).pose;
    const Eigen::Vector3d off =
        path.segments.at(each.segment).waypoints.at(each.waypoint).pose.translation() -
        should.translation();
    const double normal = off.dot(should.linear().col(2));
    const double along = std::sqrt(std::max(0.0, off.squaredNorm() - normal * normal));
    count.normal += std::abs(normal) <= kDeviations * each.expected_error_normal;
    count.along += along <= kDeviations * each.expected_error_tangential;
  }
  return count;
}

std::vector<bool> shown(const std::vector<WaypointQuality>& quality) {
  std::vector<bool> result;
  for (const WaypointQuality& each : quality)
    result.push_back(each.position_measured);
  return result;
}

void run_ours(const cases::Case& each, const cases::Scene& scene, Ours& sums) {
  const StretchParameters parameters;
  StretchResult result;
  const double processor = processor_seconds();
  sums.seconds.push_back(seconds_of([&] {
    result = stretch(surface_from_cloud(scene.reference, parameters.leaf, "reference"),
                     surface_from_cloud(scene.object, parameters.leaf, "object"), scene.path,
                     parameters);
  }));
  sums.seconds_processor.push_back(processor_seconds() - processor);
  if (must_be_accepted(each)) sums.seconds_right.push_back(sums.seconds.back());
  if (each.expected == Reason::kWrongPart) sums.seconds_wrong.push_back(sums.seconds.back());
  const bool right = each.is_right(result.verdict.reason);
  sums.right += right;
  std::printf("| %s | %s%s ", each.name.c_str(), to_string(result.verdict.reason).c_str(),
              right ? "" : " (WRONG)");
  if (!result.verdict.accepted()) {
    std::printf("| | | | | | %.2f ", sums.seconds.back());
    return;
  }
  const ToolPath truth = cases::truth_beside(result.path, scene, each);
  const cases::PathError error = cases::error_of(result.path, truth, {});
  const AsExpected expected = as_expected(result.path, truth, result.quality);
  const std::size_t count = result.quality.size();
  ++sums.accepted;
  sums.wrong_accepted += !right;
  if (right) {
    sums.gross += error.worst >= kGross;
    sums.within_goals += within_goals(error);
    sums.within_goals_where_shown +=
        within_goals(cases::error_of(result.path, truth, shown(result.quality)));
    sums.waypoints += count;
    sums.normal_as_expected += expected.normal;
    sums.along_as_expected += expected.along;
  }
  std::printf("| %.3f | %.3f | %.2f | %.2f | %.0f, %.0f | %.2f ", 1e3 * error.normal,
              1e3 * error.tangential, error.orientation * 180 / M_PI, 1e3 * error.worst,
              percent(expected.normal, count), percent(expected.along, count), sums.seconds.back());
}

/// @param converged as reported by the yardstick; the thesis' method reports nothing
void run_theirs(const cases::Case& each, const cases::Scene& scene, const ToolPath& path,
                bool converged, Theirs& sums) {
  if (!must_be_accepted(each)) {
    sums.wrong_accepted += converged;
    std::printf("| | %.2f ", sums.seconds.back());
    return;
  }
  const double worst = cases::error_of(path, cases::truth_beside(path, scene, each), {}).worst;
  sums.within += converged && worst < kGross;
  sums.gross_accepted += converged && worst >= kGross;
  std::printf("| %.2f | %.2f ", 1e3 * worst, sums.seconds.back());
}

void run_yardsticks(const cases::Case& each, const cases::Scene& scene, Sums& sums) {
  ToolPath thesis;
  sums.thesis.seconds.push_back(seconds_of(
      [&] { thesis = cases::thesis_method(scene.reference, scene.object, scene.path); }));
  run_theirs(each, scene, thesis, true, sums.thesis);
  cases::PclResult pcl;
  sums.pcl.seconds.push_back(
      seconds_of([&] { pcl = cases::pcl_pipeline(scene.reference, scene.object, scene.path); }));
  std::printf("| %s ", pcl.converged ? "converged" : "not");
  run_theirs(each, scene, pcl.path, pcl.converged, sums.pcl);
}

void run(const cases::Case& each, bool yardsticks, Sums& sums) {
  const cases::Scene scene = cases::scene_of(each);
  ++(must_be_accepted(each) ? sums.to_accept : sums.to_refuse);
  run_ours(each, scene, sums.ours);
  if (yardsticks) run_yardsticks(each, scene, sums);
  std::printf("|\n");
  std::fflush(stdout);
}

void print_theirs(const char* name, const Theirs& theirs, const Sums& sums, double our_median) {
  const double median = middle_of(theirs.seconds);
  std::printf("| %s | %zu of %zu | %zu | %zu of %zu | %.2f | %.2f |\n", name, theirs.within,
              sums.to_accept, theirs.gross_accepted, theirs.wrong_accepted, sums.to_refuse, median,
              median / our_median);
}

void print_sums(const Sums& sums, bool yardsticks) {
  const double median = middle_of(sums.ours.seconds);
  const std::size_t rightly = sums.ours.accepted - sums.ours.wrong_accepted;
  std::printf("\n### All cases together\n\n");
  std::printf("- verdicts right: %zu of %zu\n", sums.ours.right, sums.to_accept + sums.to_refuse);
  std::printf("- accepted what is to be refused: %zu; accepted but more than 5 mm off: %zu\n",
              sums.ours.wrong_accepted, sums.ours.gross);
  std::printf(
      "- of those rightly accepted, within 0.1 mm normal, 0.5 mm tangential, 1 degree: %zu of %zu; "
      "counting the tangential error only where the position is said to be measured: %zu\n",
      sums.ours.within_goals, rightly, sums.ours.within_goals_where_shown);
  std::printf(
      "- their waypoints within three times the expected error: %.1f %% normal, %.1f %% along\n",
      percent(sums.ours.normal_as_expected, sums.ours.waypoints),
      percent(sums.ours.along_as_expected, sums.ours.waypoints));
  const double of_right = middle_of(sums.ours.seconds_right);
  const double of_wrong = middle_of(sums.ours.seconds_wrong);
  std::printf(
      "- median times: %.2f s of all, %.2f s on all processors together; %.2f s where the path is "
      "to be accepted, %.2f s of a wrong part: %.1f times\n\n",
      median, middle_of(sums.ours.seconds_processor), of_right, of_wrong,
      of_right > 0 ? of_wrong / of_right : 0);
  std::printf(
      "| method | accepted, within 5 mm everywhere | accepted, but farther off | accepted what is "
      "to be refused | median s | ratio |\n|---|---|---|---|---|---|\n");
  std::printf("| here | %zu of %zu | %zu | %zu of %zu | %.2f | 1 |\n", rightly - sums.ours.gross,
              sums.to_accept, sums.ours.gross, sums.ours.wrong_accepted, sums.to_refuse, median);
  if (!yardsticks) return;
  print_theirs("thesis' general method (never refuses)", sums.thesis, sums, median);
  print_theirs("PCL: FPFH, prerejective RANSAC, ICP with scale", sums.pcl, sums, median);
}

}  // namespace

void print_case_table(const std::vector<cases::Case>& all, bool yardsticks) {
  std::printf(
      "### Cases\n\nRMS error of the path along the normal and along the surface [mm] and of its "
      "orientation [deg], and its farthest waypoint [mm]. The thesis' method has no verdict; PCL's "
      "is hasConverged().\n\n"
      "| case | verdict | normal | tangential | orientation | worst | as expected | s | thesis: "
      "worst | s "
      "| PCL: says | worst | s |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  Sums sums;
  for (const cases::Case& each : all)
    run(each, yardsticks, sums);
  print_sums(sums, yardsticks);
}

}  // namespace bench
