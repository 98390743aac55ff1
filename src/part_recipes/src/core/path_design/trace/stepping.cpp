// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/trace/stepping.h"

#include <algorithm>
#include <cmath>

namespace part_recipes::path_design {
namespace {

using Run = std::vector<TracePoint>;

double distance_to_line(const Eigen::Vector3d& point, const Eigen::Vector3d& begin,
                        const Eigen::Vector3d& end) {
  const Eigen::Vector3d way = end - begin;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp((point - begin).dot(way) / square, 0.0, 1.0) : 0;
  return (begin + share * way - point).norm();
}

/// [m] along a run, at each of its points
std::vector<double> lengths_of(const Run& run) {
  std::vector<double> lengths = {0};
  for (std::size_t i = 1; i < run.size(); ++i)
    lengths.push_back(lengths.back() + (run[i].position - run[i - 1].position).norm());
  return lengths;
}

/// Adds points at even lengths of at most a step to a run, and returns their indices.
std::vector<std::size_t> divide(Run& run, double longest) {
  constexpr double kRounding = 1e-9;  // share
  const std::vector<double> lengths = lengths_of(run);
  const double count = std::max(1.0, std::ceil(lengths.back() / longest * (1 - kRounding)));
  Run divided = {run.front()};
  std::vector<std::size_t> marks = {0};
  double mark = 1;
  for (std::size_t i = 1; i < run.size(); ++i) {
    for (; mark < count && mark / count * lengths.back() < lengths[i]; ++mark) {
      const double beyond = mark / count * lengths.back() - lengths[i - 1];
      const double share = beyond / (lengths[i] - lengths[i - 1]);
      marks.push_back(divided.size());
      divided.push_back(between(run[i - 1], run[i], share));
    }
    divided.push_back(run[i]);
  }
  marks.push_back(divided.size() - 1);
  run = divided;
  return marks;
}

/// Marks the points between two from which the line between these would be too far.
void halve(const Run& run, std::size_t begin, std::size_t end, double chord,
           std::vector<bool>& taken) {
  std::vector<std::pair<std::size_t, std::size_t>> left = {{begin, end}};
  while (!left.empty()) {
    const auto [from, to] = left.back();
    left.pop_back();
    double farthest = chord;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance =
          distance_to_line(run[i].position, run[from].position, run[to].position);
      if (distance <= farthest) continue;
      farthest = distance;
      at = i;
    }
    if (at == from) continue;
    taken[at] = true;
    left.emplace_back(from, at);
    left.emplace_back(at, to);
  }
}

void add_run(Run run, const Steps& steps, Trace& result) {
  const std::vector<std::size_t> marks = divide(run, steps.longest);
  std::vector<bool> taken(run.size(), false);
  for (const std::size_t mark : marks)
    taken[mark] = true;
  for (std::size_t i = 1; i < marks.size(); ++i)
    halve(run, marks[i - 1], marks[i], steps.chord, taken);
  for (std::size_t i = 1; i < run.size(); ++i)
    if (taken[i]) result.points.push_back(run[i]);
}

}  // namespace

Trace stepped(const Trace& trace, const Steps& steps) {
  const Trace open = opened(trace);
  Trace result;
  result.closed = trace.closed;
  result.points.push_back(open.points.front());
  Run run = {open.points.front()};
  for (std::size_t i = 1; i < open.points.size(); ++i) {
    run.push_back(open.points[i]);
    if (!open.points[i].corner && i + 1 < open.points.size()) continue;
    add_run(run, steps, result);
    run = {open.points[i]};
  }
  return result;
}

}  // namespace part_recipes::path_design
