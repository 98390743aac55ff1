// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/border/links.h"

#include <cmath>
#include <optional>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

class Linking {
 public:
  Linking(const std::vector<std::vector<Trace>>& rows, const MeshSearch& surface,
          const BorderDistance& border, const LinkLimits& limits)
      : rows_(rows), surface_(surface), border_(border), limits_(limits) {
    for (const auto& row : rows)
      used_.emplace_back(row.size(), false);
  }

  std::vector<Trace> run() {
    std::vector<Trace> result;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      for (std::size_t i = 0; i < rows_[row].size(); ++i) {
        if (used_[row][i]) continue;
        used_[row][i] = true;
        result.push_back(rows_[row][i]);
        for (std::size_t next = row + 1; next < rows_.size() && go_on(next, result.back()); ++next)
          continue;
      }
    }
    return result;
  }

 private:
  /// Adds the piece of a row that is nearest among those that can be linked, and the link to it.
  bool go_on(std::size_t row, Trace& line) {
    const Vector3d end = line.points.back().position;
    std::optional<std::size_t> best;
    Trace next;
    double least = limits_.longest;
    for (std::size_t i = 0; i < rows_[row].size(); ++i) {
      if (used_[row][i]) continue;
      for (const Trace& way : {rows_[row][i], reversed(rows_[row][i])}) {
        const double distance = (way.points.front().position - end).norm();
        if (distance >= least || !link(line.points.back(), way.points.front())) continue;
        least = distance;
        best = i;
        next = way;
      }
    }
    if (!best) return false;
    used_[row][*best] = true;
    const Trace over = *link(line.points.back(), next.points.front());
    line.points.back().corner = next.points.front().corner = true;
    line.points.insert(line.points.end(), over.points.begin(), over.points.end());
    line.points.insert(line.points.end(), next.points.begin(), next.points.end());
    return true;
  }

  /// A place that is too near to the border, moved straight away from it.
  Foot inside(Foot foot) const {
    constexpr int kTries = 3;  // chosen: on planes one is enough
    for (int i = 0; i < kTries && !border_.is_beyond(foot.point, limits_.margin); ++i) {
      const Vector3d border = border_.nearest(foot.point), away = foot.point - border;
      const double missing = limits_.margin - away.norm();
      if (away.isZero() || missing <= 0) break;
      foot = surface_.nearest(foot.point + missing * away.normalized());
    }
    return foot;
  }

  /// The places between two ends of rows, on the surface; none if the surface does not reach there.
  std::optional<Trace> link(const TracePoint& from, const TracePoint& to) const {
    constexpr double kSteps = 16;    // chosen
    constexpr double kShort = 0.98;  // of the margin; chosen
    Trace trace;
    for (double k = 1; k < kSteps; ++k) {
      const Vector3d straight = between(from, to, k / kSteps).position;
      const Foot foot = inside(surface_.nearest(straight));
      const Vector3d off = straight - foot.point;
      const double aside = (off - off.dot(foot.normal) * foot.normal).norm();
      const bool is_there = aside <= limits_.aside && off.norm() <= limits_.longest / 2;
      if (!is_there || !border_.is_beyond(foot.point, limits_.margin * kShort)) return std::nullopt;
      trace.points.push_back({foot.point, foot.normal, false});
    }
    return trace;
  }

  const std::vector<std::vector<Trace>>& rows_;
  const MeshSearch& surface_;
  const BorderDistance& border_;
  const LinkLimits limits_;
  std::vector<std::vector<bool>> used_;
};

}  // namespace

std::vector<Trace> linked(const std::vector<std::vector<Trace>>& rows, const MeshSearch& surface,
                          const BorderDistance& border, const LinkLimits& limits) {
  return Linking(rows, surface, border, limits).run();
}

}  // namespace part_recipes::path_design
