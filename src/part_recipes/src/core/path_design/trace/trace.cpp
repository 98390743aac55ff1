// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/trace/trace.h"

#include <algorithm>
#include <cmath>

namespace part_recipes::path_design {
namespace {

/// The place where a condition begins or ceases to hold.
TracePoint threshold(TracePoint holds, TracePoint fails,
                     const std::function<bool(const TracePoint&)>& predicate) {
  constexpr double kClose = 1e-8;  // [m] far below what a robot repeats
  while ((holds.position - fails.position).norm() > kClose) {
    const TracePoint middle = between(holds, fails, 0.5);
    (predicate(middle) ? holds : fails) = middle;
  }
  return holds;
}

}  // namespace

double length_of(const Trace& trace) {
  double length = 0;
  for (std::size_t i = 1; i < trace.points.size(); ++i)
    length += (trace.points[i].position - trace.points[i - 1].position).norm();
  if (trace.closed && !trace.points.empty())
    length += (trace.points.front().position - trace.points.back().position).norm();
  return length;
}

TracePoint between(const TracePoint& from, const TracePoint& to, double share) {
  return {(1 - share) * from.position + share * to.position,
          ((1 - share) * from.normal + share * to.normal).normalized(), false};
}

std::vector<Trace> kept_where(const Trace& trace, double step,
                              const std::function<bool(const TracePoint&)>& holds) {
  std::vector<Trace> kept;
  bool before = false;
  TracePoint last;
  const auto take = [&](const TracePoint& point, bool first, bool is_vertex) {
    const bool now = holds(point);
    if (now && !before) {
      kept.emplace_back();
      if (!first) kept.back().points.push_back(threshold(point, last, holds));
    } else if (!now && before) {
      kept.back().points.push_back(threshold(last, point, holds));
    }
    if (now && is_vertex) kept.back().points.push_back(point);
    before = now;
    last = point;
  };
  for (std::size_t i = 0; i < trace.points.size(); ++i) {
    const TracePoint& next = trace.points[i];
    if (i > 0) {
      const TracePoint& previous = trace.points[i - 1];
      const double steps = std::ceil((next.position - previous.position).norm() / step);
      for (double k = 1; k < steps; ++k)
        take(between(previous, next, k / steps), false, false);
    }
    take(next, i == 0, true);
  }
  kept.erase(std::remove_if(kept.begin(), kept.end(),
                            [](const Trace& each) { return each.points.size() < 2; }),
             kept.end());
  return kept;
}

Trace opened(const Trace& trace) {
  if (!trace.closed || trace.points.empty()) return trace;
  Trace open = {trace.points, false};
  const auto corner = std::find_if(open.points.begin(), open.points.end(),
                                   [](const TracePoint& point) { return point.corner; });
  if (corner != open.points.end()) {
    std::rotate(open.points.begin(), corner, open.points.end());
    // Two corners in one place are the end of one side and the start of the next.
    const TracePoint& second = open.points[1 % open.points.size()];
    if (second.corner && second.position == open.points.front().position) {
      std::rotate(open.points.begin(), open.points.begin() + 1, open.points.end());
      return open;
    }
  }
  open.points.push_back(open.points.front());
  return open;
}

Trace reversed(Trace trace) {
  std::reverse(trace.points.begin(), trace.points.end());
  return trace;
}

}  // namespace part_recipes::path_design
