// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/own_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "geometry/clusters.h"
#include "geometry/points.h"
#include "scene/laid.h"
#include "surface/complete_surface.h"
#include "verdict/checks.h"

namespace tool_path_stretcher {
namespace {

/// The chosen points, with the rest stored as `others`.
Surface part_of(const Surface& object, const Piece& chosen) {
  Surface part;
  part.oriented = object.oriented;
  part.points = select(object.points, chosen);
  part.normals = select(object.normals, chosen);
  if (!object.seen_from.empty()) part.seen_from = object.seen_from;
  std::vector<bool> is_chosen(object.points.size(), false);
  for (const std::size_t i : chosen)
    is_chosen[i] = true;
  for (std::size_t i = 0; i < is_chosen.size(); ++i) {
    if (!is_chosen[i]) part.others.push_back(object.points[i]);
  }
  complete(part);
  return part;
}

/// The result for a place that the reference explains.
struct Found {
  StretchResult result;
  bool whole;  // enough of the reference is shown to be sure that this is the part
};

/// Stretches onto what the reference explains at its found pose; none if that is everything, or too
/// little.
std::optional<Found> found_there(const Surface& object, const StretchResult& start,
                                 const StretchParameters& parameters, const StretchOnto& onto) {
  constexpr double kUseful = 0.4;   // of the points explained; below: useless pose; chosen
  constexpr double kLeast = 0.1;    // of the scan's points; chosen
  constexpr double kOverlap = 0.7;  // of the reference: its place is shown whole; chosen
  if (!start.aligned || start.inlier_ratio < kUseful) return std::nullopt;
  constexpr double kScraps = 0;  // may be noise or an edge: they stay
  const Piece own =
      explained(object, {start.mapped_reference, parameters.inlier_distance}, kScraps);
  const auto all = static_cast<double>(object.points.size());
  const double share = static_cast<double>(own.size()) / all;
  if (share < kLeast || own.size() == object.points.size()) return std::nullopt;
  if (own.size() < static_cast<std::size_t>(parameters.min_points)) return std::nullopt;
  StretchResult result = onto(part_of(object, own));
  if (result.inlier_ratio < parameters.min_inlier_ratio) return std::nullopt;
  result.verdict.message +=
      fmt::format("; {:.3g} % of the scan's points belong to other things", 100 * (1 - share));
  return Found{result, result.overlap >= kOverlap};
}

StretchResult on_two_things(const ToolPath& path, const StretchResult& one,
                            const StretchResult& other) {
  StretchResult result = one;
  result.path = {};
  result.verdict = {
      Reason::kAmbiguous,
      "object: the reference fits two things in the scan; scan only one of them, or "
      "split the scan into its objects first (clean_cloud --objects)",
      {},
      {candidate_of(path, {one.similarity, {}}), candidate_of(path, {other.similarity, {}})}};
  return result;
}

/// Pieces surrounded by gaps that may be the object alone, largest first.
std::vector<Piece> large_pieces(const Surface& object) {
  constexpr double kLarge = 0.2;    // of the scan's points; chosen
  constexpr double kWhole = 0.95;   // of the scan's points; above: already tried; chosen
  constexpr std::size_t kMost = 2;  // each is a whole search; chosen
  const auto all = static_cast<double>(object.points.size());
  std::vector<Piece> pieces = clusters(*object.tree, kGap * object.spacing);
  pieces.resize(std::min(kMost, pieces.size()));
  const auto is_useless = [all](const Piece& piece) {
    const double share = static_cast<double>(piece.size()) / all;
    return share < kLarge || share > kWhole;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_useless), pieces.end());
  return pieces;
}

/// The result shown whole, an accepted one if there is any; `first` if none is whole.
StretchResult best_of(const ToolPath& path, const std::vector<Found>& found,
                      const StretchResult& first) {
  const Found* best = nullptr;
  for (const Found& each : found) {
    if (!each.whole) continue;
    if (best == nullptr || (!best->result.verdict.accepted() && each.result.verdict.accepted()))
      best = &each;
  }
  if (best == nullptr) return first;
  for (const Found& other : found) {
    if (best->result.verdict.accepted() &&
        lie_apart(best->result.mapped_reference, other.result.mapped_reference))
      return on_two_things(path, best->result, other.result);
  }
  return best->result;
}

}  // namespace

StretchResult stretch_in_own_place(const Surface& object, const ToolPath& path,
                                   const StretchResult& first, const StretchParameters& parameters,
                                   const StretchOnto& onto) {
  constexpr double kFound = 0.5;  // of a piece's points explained by a found place; chosen
  std::vector<Found> found;
  const auto look_from = [&](const StretchResult& start) {
    if (auto there = found_there(object, start, parameters, onto)) found.push_back(*there);
  };
  look_from(first);
  for (const Piece& piece : large_pieces(object)) {
    const auto explains = [&](const Found& each) {
      const Laid laid(each.result.mapped_reference, parameters.inlier_distance);
      return laid.explains(object, piece) > kFound;
    };
    if (std::any_of(found.begin(), found.end(), explains)) continue;
    const StretchResult alone = onto(part_of(object, piece));
    look_from(alone);
  }
  return best_of(path, found, first);
}

}  // namespace tool_path_stretcher
