// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "controller/arm/flange_path.h"

namespace scan_cell_sim {

/// The line of a tool's tip between two poses, turning about one axis.
class TipLine {
 public:
  /// @param turn_radius [m] path length that a turn by one radian takes
  /// @throw ControllerRefusal naming the waypoint at its end if the turn is not unique, or there is
  /// nothing to do
  TipLine(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double turn_radius,
          std::size_t waypoint);

  Eigen::Isometry3d at(double share) const;
  double length() const { return move_.norm(); }  // [m]
  double angle() const { return turn_.norm(); }   // [rad]
  double measure() const { return measure_; }     // [m] of the path
  const Eigen::Vector3d& move() const { return move_; }
  const Eigen::Vector3d& turn() const { return turn_; }  // about its axis, in the tool
  Eigen::Matrix3d turned(double share) const;
  bool on_the_spot() const;

 private:
  Eigen::Isometry3d from_;
  Eigen::Vector3d move_;
  Eigen::Vector3d turn_;
  double measure_;
};

/// Lines of the tool's tip, each rounded into the next within the zone between them: one fades out
/// evenly while the other fades in, so that speed and turning do not jump. Waypoints are counted as
/// in the loaded path, of which this path may be the rest.
class ToolPath : public FlangePath {
 public:
  /// @param waypoints starting with the one where the tip stands
  /// @param first number of that waypoint
  /// @throw ControllerRefusal as TipLine
  ToolPath(const Eigen::Isometry3d& flange_to_tip, std::vector<TipWaypoint> waypoints,
           std::size_t first, double turn_radius);

  Eigen::Isometry3d flange(double way) const override;
  std::uint64_t waypoint(double way) const override;
  std::uint32_t outputs(double way) const override;
  double length() const override { return total_; }

  /// A part of the path: a line, or the rounding at its end.
  struct Part {
    double end;        // way; it begins where the one before ends
    std::size_t line;  // with a rounding, the one that fades out
    bool rounding;
    bool stop;  // at its end
  };
  const std::vector<Part>& parts() const { return parts_; }

  /// [1/s] from the settings.
  double programmed(const Part& part, const LineSettings& settings) const;
  /// [1/s] that the acceleration [m/s^2 of the path] allows in a rounding.
  double corner_speed(const Part& part, double acceleration) const;

 private:
  std::string name() const override { return "path"; }
  std::vector<Stretch> stretches() const override;

  Eigen::Isometry3d tip(double way) const;
  double share_of(std::size_t line) const;
  std::size_t passed(double way) const;

  Eigen::Isometry3d tip_to_flange_;
  std::vector<TipWaypoint> waypoints_;
  std::size_t first_;
  std::vector<TipLine> lines_;
  std::vector<double> begins_;     // [m] of each line, along the path
  std::vector<double> roundings_;  // [m] half of each, at the end of each line
  std::vector<double> passes_;     // way of each waypoint
  std::vector<Part> parts_;
  double total_ = 0;  // [m] of the path
  double radius_;     // [m] see TipLine
};

}  // namespace scan_cell_sim
