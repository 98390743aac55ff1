// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "registration.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "alignment/refinement.h"
#include "geometry/kd_tree.h"
#include "scan_cell_common/pose/units.h"
#include "search/candidates.h"
#include "stopwatch.h"
#include "yardsticks/pcl_pipeline.h"
#include "yardsticks/registration_data.h"

namespace bench {
namespace {

using namespace tool_path_stretcher;

using scan_cell_common::kDegree;

/// The best pose of a search over all poses; none if nothing fits.
std::optional<Similarity> searched(const Surface& reference, const Surface& object,
                                   const Prior& prior) {
  const auto candidates = find_candidates({reference, object}, prior, [](double) {});
  if (candidates.empty()) return std::nullopt;
  return candidates.front().similarity;
}

void print_line(const char* what, const std::optional<Similarity>& found, const Similarity& truth,
                double seconds) {
  if (!found) {
    std::printf("| %s | none found | | | | %.2f |\n", what, seconds);
    return;
  }
  const Eigen::Matrix3d off = found->rotation * truth.rotation.transpose();
  std::printf("| %s | %.5f | %.3f | %.4f | %.5f | %.2f |\n", what, found->scale,
              cases::angle_of(found->rotation) / kDegree, cases::angle_of(off) / kDegree,
              (found->translation - truth.translation).norm(), seconds);
}

template <class Work>
void measure(const char* what, const Similarity& truth, Work work) {
  std::optional<Similarity> found;
  const double seconds = seconds_of([&] { found = work(); });
  print_line(what, found, truth, seconds);
  std::fflush(stdout);
}

void print_head(const char* what) {
  std::printf(
      "\n### %s\n\n| how | scale | angle [deg] | rotation off [deg] | translation off [m] | s |\n"
      "|---|---|---|---|---|---|\n",
      what);
}

void print_car(const std::string& data) {
  constexpr double kLeaf = 0.02;  // [m] for a cloud of several metres
  const cases::Pair car = cases::car_pair(data);
  print_head("Car");
  print_line("truth, from the rows", car.truth, car.truth, 0);
  const Eigen::Vector3d leaf = Eigen::Vector3d::Constant(kLeaf);
  Surface reference, object;
  const double surfaces = seconds_of([&] {
    reference = surface_from_cloud(car.reference, leaf, "reference");
    object = surface_from_cloud(car.object, leaf, "object");
  });
  measure("here, from identity", car.truth, [&] {
    return refine({reference, object}, Similarity(), ScalePrior{}, Density::kMany, 60);
  });
  measure("here, nothing known", car.truth, [&] { return searched(reference, object, Prior{}); });
  measure("PCL's ICP with scale, from identity", car.truth, [&] {
    return cases::pcl_icp(car.reference, car.object, std::numeric_limits<double>::max()).similarity;
  });
  measure("PCL's features and ICP", car.truth,
          [&] { return cases::pcl_pipeline(car.reference, car.object, {}).similarity; });
  std::printf("\n(here: and %.2f s for both surfaces)\n", surfaces);
}

/// The points around the one with the most neighbours, as cropping by hand would leave them.
Points cropped(const Points& points, double radius) {
  const KdTree tree(points);
  std::vector<KdTree::Neighbour> near, most;
  for (const Eigen::Vector3d& point : points) {
    tree.within(point, radius, near);
    if (near.size() > most.size()) most = near;
  }
  Points kept;
  for (const auto& each : most)
    kept.push_back(points[each.index]);
  return kept;
}

void print_bunny_problem(const cases::Pair& bunny) {
  constexpr double kLeaf = 1e-5;  // [m] reduces nothing
  const Eigen::Vector3d leaf = Eigen::Vector3d::Constant(kLeaf);
  const Surface reference = surface_from_cloud(bunny.reference, leaf, "reference");
  const Surface object = surface_from_cloud(bunny.object, leaf, "object");
  measure("here, nothing known", bunny.truth, [&] { return searched(reference, object, {}); });
  measure("here, size known", bunny.truth, [&] {
    return searched(reference, object, {ScalePrior{1, 0}, {}});
  });
  measure("PCL's features and ICP", bunny.truth,
          [&] { return cases::pcl_pipeline(bunny.reference, bunny.object, {}).similarity; });
}

void print_bunny(const std::string& data) {
  constexpr std::size_t kDraws = 1700;
  constexpr double kRadius = 0.2;  // [m] the bunny is as long
  std::printf("\nBunny, published by TEASER: rotation 0.078 deg off, translation 0.0025 off.\n");
  print_head("Bunny without outliers");
  print_bunny_problem(cases::bunny_pair(data, 0));
  cases::Pair bunny = cases::bunny_pair(data, kDraws);
  print_head("Bunny with 1,700 draws of outliers");
  print_bunny_problem(bunny);
  bunny.object = cropped(bunny.object, kRadius);
  std::printf("\n%zu points are left when the object is cropped to 0.2 m.\n", bunny.object.size());
  print_head("Bunny with 1,700 draws of outliers, cropped");
  print_bunny_problem(bunny);
}

}  // namespace

void print_registration(const std::string& data) {
  if (!cases::has_registration_data(data)) {
    std::printf(
        "\nNot run: car and bunny; SCAN_CELL_DATA does not name a folder with registration/\n");
    return;
  }
  print_car(data);
  print_bunny(data);
}

}  // namespace bench
