// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/trace/waypoints.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>

#include "scan_cell_common/errors/errors.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;

class Poses {
 public:
  Poses(const Trace& trace, const Pose& pose, std::string name)
      : points_(trace.points), closed_(trace.closed), pose_(pose), name_(std::move(name)) {}

  tool_paths::Segment segment() const {
    tool_paths::Segment segment;
    segment.name = name_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3d arriving = way(i, -1), leaving = way(i, 1);
      if (points_[i].corner) {
        add_corner(points_[i], arriving, leaving, segment);
      } else {
        add(points_[i], arriving.normalized() + leaving.normalized(), segment);
      }
    }
    return segment;
  }

 private:
  /// Direction to the next point (1), or from the previous one (-1); zero at a corner's other side
  /// or the end of an open trace.
  Vector3d way(std::size_t i, int direction) const {
    const std::size_t last = points_.size() - 1;
    std::size_t from = i;
    const bool at_end = direction > 0 ? i == last : i == 0;
    if (at_end) {
      if (!closed_ || points_[i].corner) return Vector3d::Zero();
      from = direction > 0 ? 0 : last;  // the same place
    }
    const std::size_t to = direction > 0 ? from + 1 : from - 1;
    return direction * (points_[to].position - points_[from].position);
  }

  void add_corner(const TracePoint& point, const Vector3d& arriving, const Vector3d& leaving,
                  tool_paths::Segment& segment) const {
    if (arriving.isZero() || leaving.isZero()) {
      add(point, arriving + leaving, segment);
      return;
    }
    const Eigen::Matrix3d before = rotation(point.normal, arriving, segment),
                          after = rotation(point.normal, leaving, segment);
    if (Eigen::AngleAxisd(before.transpose() * after).angle() <= pose_.corner_angle) {
      add(point, arriving.normalized() + leaving.normalized(), segment);
    } else {
      add(point, arriving, segment);
      add(point, leaving, segment);
    }
  }

  void add(const TracePoint& point, const Vector3d& travel, tool_paths::Segment& segment) const {
    tool_paths::Waypoint waypoint;
    waypoint.pose.linear() = rotation(point.normal, travel, segment);
    waypoint.pose.translation() = point.position + pose_.stand_off * point.normal;
    segment.waypoints.push_back(waypoint);
  }

  Eigen::Matrix3d rotation(const Vector3d& normal, const Vector3d& travel,
                           const tool_paths::Segment& segment) const {
    constexpr double kAlong = 0.02;  // sine: about 1 degree; chosen
    const Vector3d z = pose_.z == WaypointZ::kIntoPart ? Vector3d(-normal) : normal;
    const Vector3d wanted = pose_.x ? *pose_.x : travel;
    Vector3d x = wanted - wanted.dot(z) * z;
    if (!(x.norm() > kAlong * wanted.norm())) {
      if (pose_.x) {
        throw scan_cell_common::Refused(
            fmt::format("{}, waypoint {}", name_, segment.waypoints.size() + 1),
            "the direction of --tool-x is along the surface's normal", "give another");
      }
      x = z.unitOrthogonal();  // of a place with no way to or from it
    }
    x.normalize();
    Eigen::Matrix3d result;
    result << x, z.cross(x), z;
    return result;
  }

  const std::vector<TracePoint>& points_;
  const bool closed_;
  const Pose& pose_;
  const std::string name_;
};

}  // namespace

tool_paths::Segment waypoints_of(const Trace& stepped, const Pose& pose, const std::string& name) {
  return Poses(stepped, pose, name).segment();
}

}  // namespace part_recipes::path_design
