// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "deviation/deviations.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/geometry/point_tree.h"

namespace part_recipes {
namespace {

using Eigen::Vector3d;
using scan_cell_common::PointTree;
using scan_cell_common::UnusableInput;

constexpr std::size_t kAround = 20;  // neighbours that tell a spacing, as the stretcher does

void check_finite(const Points& object) {
  const auto bad = std::count_if(object.begin(), object.end(),
                                 [](const Vector3d& point) { return !point.allFinite(); });
  if (bad == 0) return;
  throw UnusableInput("object", fmt::format("{} of {} points are not finite", bad, object.size()),
                      "remove them, for instance with rosrun cloud_preprocess clean_cloud");
}

}  // namespace

double spacing_of(const Points& points) {
  if (points.size() < kAround) {
    throw UnusableInput("object", fmt::format("{} points", points.size()),
                        fmt::format("scan the part again: {} are needed", kAround));
  }
  constexpr std::size_t kLooked = 2000;  // points, evenly through the cloud; chosen
  const PointTree tree(points);
  std::vector<double> spacings;
  for (std::size_t i = 0; i < points.size();
       i += std::max<std::size_t>(1, points.size() / kLooked)) {
    std::array<PointTree::Index, kAround> found{};
    std::array<double, kAround> squared{};
    tree.nearest(points[i].data(), kAround, found.data(), squared.data());
    spacings.push_back(std::sqrt(M_PI * squared.back() / static_cast<double>(kAround)));
  }
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

Reach reach_of(double tolerance, double spacing) {
  constexpr double kTolerances = 10;  // a part farther off is another part; chosen
  constexpr double kSpacings = 3;     // below it a coarse scan shows nothing; chosen
  return {std::max(kTolerances * tolerance, kSpacings * spacing), spacing};
}

Deviations measure(const ReferenceSurface& reference,
                   const tool_path_stretcher::Similarity& similarity, const Points& object,
                   double tolerance) {
  check_finite(object);
  Deviations deviations;
  deviations.reach = reach_of(tolerance, spacing_of(object));
  const Reach on_reference{deviations.reach.normal / similarity.scale,
                           deviations.reach.lateral / similarity.scale};
  deviations.values.reserve(object.size());
  for (const Vector3d& point : object) {
    deviations.values.push_back(similarity.scale *
                                reference.signed_distance(similarity.inverse(point), on_reference));
  }
  return deviations;
}

std::vector<bool> scanned(const ReferenceSurface::Samples& samples,
                          const tool_path_stretcher::Similarity& similarity, const Points& object,
                          const Reach& reach) {
  constexpr double kLateral = 2;  // spacings: a hole in the scan is wider than that; chosen
  const double lateral = kLateral * reach.lateral;
  const PointTree tree(object);
  std::vector<bool> result(samples.points.size(), false);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Vector3d at = similarity * samples.points[i];
    PointTree::Index nearest = 0;
    double squared = 0;
    if (tree.nearest(at.data(), 1, &nearest, &squared) == 0) continue;
    const Vector3d way = object[nearest] - at;
    const Vector3d normal = similarity.rotation * samples.normals[i];
    const double height = way.dot(normal);
    result[i] = std::abs(height) <= reach.normal && (way - height * normal).norm() <= lateral;
  }
  return result;
}

double unscanned_share(const std::vector<bool>& scanned) {
  if (scanned.empty()) return 0;
  return static_cast<double>(std::count(scanned.begin(), scanned.end(), false)) /
         static_cast<double>(scanned.size());
}

}  // namespace part_recipes
