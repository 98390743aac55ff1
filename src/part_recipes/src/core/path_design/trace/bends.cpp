// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/trace/bends.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

/// Where the shortest way from a place on one plane to a place on another crosses their common
/// line: it is straight once one plane is unfolded onto the other.
Vector3d crossing(const TracePoint& from, const TracePoint& to) {
  const Vector3d line = from.normal.cross(to.normal).normalized();
  Eigen::Matrix3d planes;
  planes << from.normal.transpose(), to.normal.transpose(), line.transpose();
  const Vector3d middle = (from.position + to.position) / 2;
  const Vector3d on_line =
      planes.inverse() *
      Vector3d(from.normal.dot(from.position), to.normal.dot(to.position), line.dot(middle));
  const double at_from = line.dot(from.position - on_line), at_to = line.dot(to.position - on_line);
  const double off_from = (from.position - on_line - at_from * line).norm();
  const double off_to = (to.position - on_line - at_to * line).norm();
  const double both = off_from + off_to;
  return both > 0 ? Vector3d(on_line + (at_from * off_to + at_to * off_from) / both * line)
                  : on_line;
}

}  // namespace

Trace with_bends(const Trace& trace, double crease_angle) {
  Trace result;
  result.closed = trace.closed;
  for (const TracePoint& point : trace.points) {
    if (!result.points.empty()) {
      const TracePoint last = result.points.back();
      if (last.normal.dot(point.normal) < std::cos(crease_angle)) {
        const Vector3d corner = crossing(last, point);
        result.points.push_back({corner, last.normal, true});
        result.points.push_back({corner, point.normal, true});
      }
    }
    result.points.push_back(point);
  }
  return result;
}

}  // namespace part_recipes::path_design
