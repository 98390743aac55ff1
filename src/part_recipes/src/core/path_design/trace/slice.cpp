// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/trace/slice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

using EdgeKey = std::uint64_t;  // both vertices: the same from either side

/// Where a plane cuts a triangle.
struct Cut {
  EdgeKey enters, leaves;
  TracePoint begin, end;
};

struct Heights {
  std::array<double, 3> over;  // [m] of the corners over the plane; 0 counts as above
};

/// The point at which the edge from corner i to the next crosses the plane, the same from either
/// side of the edge.
TracePoint crossing(const PartMesh& mesh, std::size_t t, std::size_t i, const Heights& heights) {
  std::size_t a = i, b = (i + 1) % 3;
  if (mesh.triangles[t][a] > mesh.triangles[t][b]) std::swap(a, b);
  const TracePoint from = {mesh.vertices[mesh.triangles[t][a]], mesh.normals[t][a], false};
  const TracePoint to = {mesh.vertices[mesh.triangles[t][b]], mesh.normals[t][b], false};
  return between(from, to, heights.over[a] / (heights.over[a] - heights.over[b]));
}

EdgeKey key_of(const Triangle& triangle, std::size_t i) {
  const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
  return (static_cast<EdgeKey>(low) << 32U) | high;
}

/// @return false if the plane misses the triangle
bool cut_triangle(const PartMesh& mesh, std::size_t t, const Heights& heights, Cut& result) {
  bool found = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool above = heights.over[i] >= 0, next_above = heights.over[(i + 1) % 3] >= 0;
    if (above == next_above) continue;
    found = true;
    const EdgeKey key = key_of(mesh.triangles[t], i);
    if (above) {
      result.enters = key;
      result.begin = crossing(mesh, t, i, heights);
    } else {
      result.leaves = key;
      result.end = crossing(mesh, t, i, heights);
    }
  }
  return found;
}

std::vector<std::vector<Cut>> cuts_of(const PartMesh& mesh, const Planes& planes) {
  std::vector<std::vector<Cut>> cuts(planes.count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<double, 3> at{};
    for (std::size_t i = 0; i < 3; ++i)
      at[i] = planes.across.dot(mesh.vertices[mesh.triangles[t][i]]) - planes.first;
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    const double from = std::max(0.0, std::ceil(*low / planes.spacing) - 1);
    const double to =
        std::min(static_cast<double>(planes.count) - 1, std::floor(*high / planes.spacing) + 1);
    for (double plane = from; plane <= to; ++plane) {
      Heights heights{};
      for (std::size_t i = 0; i < 3; ++i)
        heights.over[i] = at[i] - plane * planes.spacing;
      Cut result{};
      if (cut_triangle(mesh, t, heights, result))
        cuts[static_cast<std::size_t>(plane)].push_back(result);
    }
  }
  return cuts;
}

/// Adds the place between two triangles, with both normals if the surface bends there.
void add_joint(const TracePoint& arriving, const TracePoint& leaving, Trace& trace) {
  constexpr double kSame = 0.9998;  // cosine: 1 degree; normals of a smooth surface are the same
  if (arriving.normal.dot(leaving.normal) > kSame) {
    trace.points.push_back(leaving);
    return;
  }
  for (const TracePoint& side : {arriving, leaving})
    trace.points.push_back({side.position, side.normal, true});
}

/// Follows the cuts of one plane from triangle to triangle.
class Chains {
 public:
  explicit Chains(const std::vector<Cut>& cuts) : cuts_(cuts), used_(cuts.size(), false) {
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      begins_.emplace_back(cuts[i].enters, i);
      ends_.push_back(cuts[i].leaves);
    }
    std::sort(begins_.begin(), begins_.end());
    std::sort(ends_.begin(), ends_.end());
  }

  std::vector<Trace> traces() {
    std::vector<Trace> result;
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const bool is_first = !std::binary_search(ends_.begin(), ends_.end(), cuts_[i].enters);
      if (is_first && !used_[i]) result.push_back(follow(i));
    }
    for (std::size_t i = 0; i < cuts_.size(); ++i)
      if (!used_[i]) result.push_back(follow(i));
    return result;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t next_of(std::size_t i) const {
    const EdgeKey key = cuts_[i].leaves;
    for (auto at = std::lower_bound(begins_.begin(), begins_.end(), std::pair(key, std::size_t{0}));
         at != begins_.end() && at->first == key; ++at)
      if (!used_[at->second]) return at->second;
    return kNone;
  }

  Trace follow(std::size_t start) {
    Trace trace;
    trace.points.push_back(cuts_[start].begin);
    std::size_t now = start;
    used_[now] = true;
    for (std::size_t next = next_of(now); next != kNone; next = next_of(now)) {
      add_joint(cuts_[now].end, cuts_[next].begin, trace);
      used_[next] = true;
      now = next;
    }
    if (cuts_[now].leaves == cuts_[start].enters && now != start) {
      trace.closed = true;
      trace.points.erase(trace.points.begin());
      add_joint(cuts_[now].end, cuts_[start].begin, trace);
    } else {
      trace.points.push_back(cuts_[now].end);
    }
    return trace;
  }

  const std::vector<Cut>& cuts_;
  std::vector<bool> used_;
  std::vector<std::pair<EdgeKey, std::size_t>> begins_;
  std::vector<EdgeKey> ends_;
};

}  // namespace

std::vector<std::vector<Trace>> cut(const PartMesh& mesh, const Planes& planes) {
  std::vector<std::vector<Trace>> traces;
  for (const std::vector<Cut>& cuts : cuts_of(mesh, planes))
    traces.push_back(Chains(cuts).traces());
  return traces;
}

std::vector<Trace> joined_over_gaps(std::vector<Trace> lines, const Vector3d& along, double gap) {
  std::stable_sort(lines.begin(), lines.end(), [&along](const Trace& one, const Trace& other) {
    return along.dot(one.points.front().position) < along.dot(other.points.front().position);
  });
  std::vector<Trace> joined;
  for (Trace& line : lines) {
    const TracePoint& begin = line.points.front();
    const auto before = std::find_if(joined.begin(), joined.end(), [&](const Trace& each) {
      return (begin.position - each.points.back().position).norm() <= gap;
    });
    if (before == joined.end()) {
      joined.push_back(std::move(line));
      continue;
    }
    TracePoint& end = before->points.back();
    const bool bends = end.normal.dot(begin.normal) < 0.9998;  // cosine: 1 degree, as add_joint()
    const bool same_place = (end.position - begin.position).norm() < 1e-9;  // [m]
    if (bends) end.corner = line.points.front().corner = true;
    before->points.insert(before->points.end(),
                          line.points.begin() + (same_place && !bends ? 1 : 0), line.points.end());
  }
  return joined;
}

}  // namespace part_recipes::path_design
