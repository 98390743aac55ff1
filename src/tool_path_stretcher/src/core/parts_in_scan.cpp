// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/parts_in_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/points.h"
#include "scan_cell_common/errors/errors.h"
#include "scene/laid.h"
#include "sight/seeable.h"
#include "tool_path_stretcher/stretcher.h"

namespace tool_path_stretcher {
namespace {

/// Share of the visible reference that must be shown to be sure of its part. For a closed
/// reference: of what faces the viewer. For a scan: of all of it, since another view may miss its
/// walls. Chosen.
double sure_share(const Surface& reference) {
  return reference.closed ? 0.7 : 0.5;
}

/// A pose of the reference in the scan.
struct Lying {
  Similarity similarity;
  Points mapped;  // [m] what the scan can show of it, with its deformation
  Piece thing;    // of the scan, on which it was laid
};

/// The search of one reference in one scan.
class PartSearch {
 public:
  PartSearch(const Surface& reference, const Points& scan, const StretchParameters& parameters)
      : reference_(reference),
        scan_(scan),
        parameters_(parameters),
        surface_(surface_from_cloud(scan, parameters.leaf, "scan")),
        middle_(principal_frame(reference.points).centroid) {}

  bool found() const { return !found_.empty(); }

  void look_at(const Piece& thing) {
    if (is_known(thing)) return;
    const StretchResult result = laid_on(thing);
    const Verdict& verdict = result.verdict;
    const double shown = verdict.accepted() ? shown_of(result, thing) : 0;
    if (verdict.accepted() && shown >= sure_share(reference_)) {
      add({result.similarity, result.mapped_reference, thing}, found_);
    } else if (verdict.accepted()) {
      add({result.similarity, result.mapped_reference, thing}, unsure_);
    } else if (verdict.reason == Reason::kAmbiguous) {
      for (const PoseCandidate& each : verdict.candidates)
        add({each.similarity, all_at(each.similarity), thing}, found_);
    }
    if (found() || thing.size() <= most_points_) return;
    most_points_ = thing.size();
    why_none_ = verdict.accepted() ? too_little(shown) : verdict.message;
  }

  PartsInScan result() const {
    PartsInScan result;
    for (const Lying& lying : found_)
      result.parts.push_back(part_at(lying));
    for (const Lying& lying : unsure_) {
      if (!is_known(lying.thing) && is_rival(lying)) result.parts.push_back(part_at(lying));
    }
    if (result.parts.size() == 1) add_what_was_torn_off(result.parts.front());
    if (!found()) result.why_none = why_none_;
    return result;
  }

 private:
  /// Whether the thing belongs to a found part, or is too small to be another such part.
  bool is_known(const Piece& thing) const {
    constexpr double kOf = 0.5;     // of its points that are explained; chosen
    constexpr double kAlike = 0.2;  // of the found thing's points; chosen
    return std::any_of(found_.begin(), found_.end(), [&](const Lying& lying) {
      if (static_cast<double>(thing.size()) < kAlike * static_cast<double>(lying.thing.size()))
        return true;
      const Laid laid = laid_at(lying);
      const auto on = std::count_if(thing.begin(), thing.end(),
                                    [&](std::size_t i) { return laid.explains(scan_[i]); });
      return static_cast<double>(on) > kOf * static_cast<double>(thing.size());
    });
  }

  /// The share of the visible reference that a thing shows. For a closed reference, faces at a
  /// grazing angle are left out: no scanner need see them.
  double shown_of(const StretchResult& result, const Piece& thing) const {
    if (!reference_.closed) return result.overlap;
    constexpr double kFacing = 0.5;  // cosine, 60 degrees; chosen
    constexpr double kBent = 0.02;   // of the size: deviation from the similarity; chosen
    const KdTree points(select(scan_, thing));
    const double bent = result.deformation_nodes > 0 ? kBent * reference_.size : 0;
    const double reach =
        parameters_.inlier_distance + result.similarity.scale * (reference_.spacing + bent);
    const auto is_shown = [&](const Eigen::Vector3d& point) {
      return points.nearest(result.similarity * point).squared_distance < reach * reach;
    };
    Eigen::Vector3d side = Eigen::Vector3d::Zero();
    for (const std::size_t i : reference_.samples.many) {
      if (is_shown(reference_.points[i])) side += reference_.normals[i];
    }
    if (side.isZero()) return 0;
    side.normalize();
    const Surface seeable = seeable_part(reference_, {side});
    double facing = 0, shown = 0;
    for (std::size_t i = 0; i < seeable.points.size(); ++i) {
      if (seeable.normals[i].dot(side) < kFacing) continue;
      facing += 1;
      shown += is_shown(seeable.points[i]) ? 1 : 0;
    }
    return facing > 0 ? shown / facing : 0;
  }

  StretchResult laid_on(const Piece& thing) const {
    try {
      const Surface object = surface_from_cloud(select(scan_, thing), parameters_.leaf, "object");
      return lay(reference_, object, parameters_);
    } catch (const scan_cell_common::UnusableInput& error) {  // such as one line of points
      StretchResult none;
      none.verdict = {Reason::kUnusableInput, error.what(), {}};
      return none;
    }
  }

  std::string too_little(double overlap) const {
    return fmt::format(
        "it shows {:.3g} % of what could be seen of the reference; {:.3g} % are needed "
        "to be sure that it is the same part",
        100 * overlap, 100 * sure_share(reference_));
  }

  bool lie_together(const Lying& one, const Lying& other) const {
    constexpr double kOther = 0.05;  // of the size: another place; chosen
    const double far = (one.similarity * middle_ - other.similarity * middle_).norm();
    return far < kOther * one.similarity.scale * reference_.size;
  }

  void add(Lying lying, std::vector<Lying>& others) const {
    const auto is_there = [&](const Lying& other) { return lie_together(lying, other); };
    if (std::none_of(others.begin(), others.end(), is_there)) others.push_back(std::move(lying));
  }

  /// Whether it may be another part of the same kind as a found one, of which less is seen.
  bool is_rival(const Lying& lying) const {
    constexpr double kSize = 1.1;  // times the size, the same kind; chosen
    const auto is_like = [&](const Lying& other) {
      const double ratio = lying.similarity.scale / other.similarity.scale;
      return ratio < kSize && ratio > 1 / kSize && !lie_together(lying, other);
    };
    return std::any_of(found_.begin(), found_.end(), is_like);
  }

  /// Repeats the registration with pieces torn off a deformed part, which are then explained
  /// better.
  void add_what_was_torn_off(FoundPart& part) const {
    constexpr double kMore = 0.02;  // of the thing's points; chosen
    const Lying& lying = found_.front();
    std::vector<bool> is_of_thing(scan_.size(), false);
    for (const std::size_t i : lying.thing)
      is_of_thing[i] = true;
    const auto more = std::count_if(part.explained.begin(), part.explained.end(),
                                    [&](std::size_t i) { return !is_of_thing[i]; });
    if (static_cast<double>(more) < kMore * static_cast<double>(lying.thing.size())) return;
    const StretchResult again = laid_on(part.explained);
    if (!again.verdict.accepted() || lie_apart(again.mapped_reference, lying.mapped)) return;
    part = part_at({again.similarity, again.mapped_reference, {}});
  }

  FoundPart part_at(const Lying& lying) const {
    constexpr double kScraps = 0.5;  // of their points; chosen
    const Laid laid = laid_at(lying);
    std::vector<bool> is_own(surface_.points.size(), false);
    for (const std::size_t i : explained(surface_, laid, kScraps))
      is_own[i] = true;
    FoundPart part{laid.points(), {}};
    for (std::size_t i = 0; i < scan_.size(); ++i) {
      if (is_own[surface_.tree->nearest(scan_[i]).index]) part.explained.push_back(i);
    }
    return part;
  }

  /// Includes the sides that the scan was not expected to show.
  Laid laid_at(const Lying& lying) const {
    return {lying.mapped, parameters_.inlier_distance, all_at(lying.similarity)};
  }

  Points all_at(const Similarity& similarity) const {
    Points points = reference_.points;
    for (Eigen::Vector3d& point : points)
      point = similarity * point;
    return points;
  }

  const Surface& reference_;
  const Points& scan_;
  const StretchParameters& parameters_;
  const Surface surface_;         // of the scan
  const Eigen::Vector3d middle_;  // of the reference [m]
  std::vector<Lying> found_;
  std::vector<Lying> unsure_;  // a flat thing fits any flat face, like a partial scan
  std::string why_none_ = "there is too little of it";  // of the largest thing
  std::size_t most_points_ = 0;
};

}  // namespace

PartsInScan parts_in_scan(const Surface& reference, const Points& scan,
                          const std::vector<std::vector<std::size_t>>& things,
                          const StretchParameters& parameters) {
  std::vector<Piece> pieces = things;
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& one, const Piece& other) { return one.size() > other.size(); });
  PartSearch search(reference, scan, parameters);
  for (const Piece& piece : pieces)
    search.look_at(piece);
  if (!search.found() && pieces.size() > 1) {
    Piece all;
    for (const Piece& piece : pieces)
      all.insert(all.end(), piece.begin(), piece.end());
    search.look_at(all);
  }
  return search.result();
}

}  // namespace tool_path_stretcher
