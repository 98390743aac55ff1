// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "views/views.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "placement/air.h"
#include "verdict/ambiguity.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {
namespace {

/// The mean of the reference's normals where the object lies on it.
Eigen::Vector3d side_of(const SurfacePair& surfaces, const Mapping& mapping) {
  constexpr double kOn = 2;  // spacings; chosen
  const auto& [reference, object] = surfaces;
  const double most = std::pow(kOn * object.spacing, 2);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::size_t i : reference.samples.many) {
    if (object.tree->nearest(mapping * reference.points[i]).squared_distance < most)
      sum += reference.normals[i];
  }
  return sum.isZero() ? Eigen::Vector3d(Eigen::Vector3d::UnitZ()) : sum.normalized();
}

/// The mappings that may be right, likeliest first.
std::vector<Mapping> likely(const Attempt& whole) {
  constexpr double kNear = 1.5;  // times the least cost; chosen
  std::vector<Mapping> result;
  for (const Fitted& each : whole.fitted)
    result.push_back(each.mapping);
  const auto second = result.begin() + (result.empty() ? 0 : 1);
  std::vector<Mapping> rigid;
  for (const Candidate& each : whole.candidates) {
    if (each.cost < kNear * whole.candidates.front().cost) rigid.push_back({each.similarity, {}});
  }
  result.insert(second, rigid.begin(), rigid.end());
  return result;
}

}  // namespace

std::vector<ViewPrior> possible_views(const SurfacePair& surfaces, const Attempt& whole) {
  constexpr double kAlike = 20 * M_PI / 180;  // [rad] hidden areas change little within; chosen
  constexpr std::size_t kMost = 4;            // each is a whole attempt; chosen
  std::vector<ViewPrior> views;
  const auto add = [&views](const ViewPrior& view) {
    const bool is_known = std::any_of(views.begin(), views.end(), [&](const ViewPrior& other) {
      return ViewPrior{view.of_reference, other.of_reference, kAlike}.allows(
          Eigen::Matrix3d::Identity());
    });
    if (!is_known && views.size() < kMost) views.push_back(view);
  };
  const Points& seen_from = surfaces.object.seen_from;
  for (const Mapping& each : likely(whole)) {
    const Eigen::Matrix3d& rotation = each.similarity.rotation;
    if (!seen_from.empty()) {  // as it lies, or turned over (the other face of a sheet)
      add({turned(seen_from, rotation.transpose()), seen_from});
      add({turned(seen_from, -rotation.transpose()), seen_from});
      continue;
    }
    const Points side = {side_of(surfaces, each)};
    add({side, turned(side, rotation)});
    add({turned(side, -Eigen::Matrix3d::Identity()), turned(side, -rotation)});
  }
  return views;
}

namespace {

/// Compares the object's points alone: two attempts have different references.
bool explains_more(const Attempt& one, const Attempt& other) {
  Explanation first = one.fitted.front().explanation;
  Explanation second = other.fitted.front().explanation;
  first.reference = {};
  second.reference = {};
  return clearly_better(first, second);
}

/// Whether the whole reference explains points that its visible part does not: they were seen from
/// elsewhere.
bool shows_other_sides(const Attempt& whole, const Attempt& part) {
  constexpr double kMore = 0.05;  // of the object's points; chosen
  if (whole.fitted.empty() || !explains_more(whole, part)) return false;
  return whole.fitted.front().explanation.inlier_ratio >
         part.fitted.front().explanation.inlier_ratio + kMore;
}

/// Whether several poses of the whole reference explain the object equally well, and this one does
/// not explain all of it either: the right one may not be among them.
bool is_one_of_many(const Attempt& part, const Attempt& whole) {
  constexpr double kAll = 0.95;  // of the object's points; chosen
  return whole.result.verdict.reason == Reason::kAmbiguous &&
         part.fitted.front().explanation.inlier_ratio < kAll;
}

StretchResult ambiguous(const Attempt& one, const Attempt& other, const ToolPath& path) {
  StretchResult result = one.result;
  try {
    refuse_ambiguous(path, one.fitted.front().mapping, other.fitted.front().mapping);
  } catch (const Refusal& refusal) {
    result.verdict = refusal.verdict;
    result.path = {};
  }
  return result;
}

}  // namespace

StretchResult judge(const std::vector<Attempt>& attempts, const ToolPath& path,
                    const SurfacePair& surfaces, const StretchParameters& parameters) {
  const Attempt& whole = attempts.front();
  const Attempt* best = nullptr;
  const auto counts = [](const Attempt& each) { return !each.whole && !each.fitted.empty(); };
  for (const Attempt& each : attempts) {
    if (counts(each) && (best == nullptr || explains_more(each, *best))) best = &each;
  }
  if (best == nullptr) return whole.result;
  if (surfaces.object.seen_from.empty() && shows_other_sides(whole, *best)) return whole.result;
  const ToolPath touching = on_surface(path, surfaces.reference, parameters);
  const Attempt* accepted = nullptr;
  for (const Attempt& each : attempts) {
    if (!counts(each) || explains_more(*best, each)) continue;
    if (each.result.verdict.reason == Reason::kAmbiguous) return each.result;
    if (!each.result.verdict.accepted()) continue;
    if (accepted != nullptr &&
        !same_path(touching, accepted->fitted.front().mapping, each.fitted.front().mapping,
                   parameters.ambiguity_distance))
      return ambiguous(*accepted, each, path);
    if (accepted == nullptr || each.result.overlap > accepted->result.overlap) accepted = &each;
  }
  if (accepted == nullptr) return best->result;
  return is_one_of_many(*accepted, whole) ? whole.result : accepted->result;
}

}  // namespace tool_path_stretcher
