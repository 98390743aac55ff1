// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "scan_cell_sim/controller/kinematics.h"
#include "scan_cell_sim/controller/refusal.h"

namespace scan_cell_sim {

/// The robot's path without its timing: `way` runs from 0 to 1.
class Path {
 public:
  virtual ~Path() = default;
  virtual Eigen::Isometry3d flange(
      double way) const = 0;                    //!< tool0 in base_link [m], at a way from 0 to 1
  virtual Joints joints(double way) const = 0;  //!< [rad] at a way from 0 to 1

  /// On a path of the tool, the last waypoint passed at a way; else 0.
  virtual std::uint64_t waypoint(double) const { return 0; }
  /// On a path of the tool, the outputs that are on at a way; else none.
  virtual std::uint32_t outputs(double) const { return 0; }
};

/// A part of a path with its speed limits, in ways per second.
struct SpeedStep {
  double end = 1;            //!< way; it begins where the one before ends
  double speed = 1;          //!< [1/s] as programmed; the override multiplies it
  double max_speed = 1;      //!< [1/s] what the axes and the corner allow
  double reduced_speed = 1;  //!< [1/s] at which the flange moves at 250 mm/s at most
  bool stop = false;         //!< at its end
};

/// A path with its speed limits, in ways per second.
struct PlannedPath {
  std::shared_ptr<const Path> path;  //!< to run
  double speed = 1;                  //!< [1/s] as programmed; the override multiplies it
  double max_speed = 1;              //!< [1/s] what the axes allow
  double acceleration = 1;           //!< [1/s^2]
  std::vector<SpeedStep> steps;      //!< of a path of the tool, instead of the speeds; else none
};

/// Speeds along a line or an arc.
struct LineSettings {
  double speed = 0.25;                 //!< [m/s]
  double acceleration = 1.0;           //!< [m/s^2]
  double rotational_speed = M_PI / 3;  //!< [rad/s]; reached in no less than a quarter of a second
  bool euler = false;  //!< on a line, interpolate A, E, R instead of turning about one fixed axis
};

/// All axes start and end together, each within its speed and acceleration.
/// @throw ControllerRefusal if `to` is outside the ranges
PlannedPath plan_joint_path(const Joints& from, const Joints& to);

/// A straight line of the flange from its pose at `from`, in the posture of `from`.
/// @throw ControllerRefusal if any part of it, its ends too, is out of reach, outside the ranges or
/// singular: J5 or the bend of the elbow within half a degree of 0 or passing 0, the wrist's centre
/// within 5 mm of axis 1 or passing it; or if an axis turns by more than 20 degrees while the
/// flange moves 10 mm or turns by 2 degrees
PlannedPath plan_line(const Joints& from, const Eigen::Isometry3d& to,
                      const LineSettings& settings);

/// An arc of the flange from its pose at `from`, through `via`: along the circle through the three
/// positions, turning about one axis to the orientation of `via` and about one from there.
/// @throw ControllerRefusal as plan_line(), and if two of the three positions are nearer than 1 mm,
/// one lies within 0.1 mm of the line through the others, or a turn is within 0.1 degree of half a
/// turn
PlannedPath plan_arc(const Joints& from, const Eigen::Isometry3d& via, const Eigen::Isometry3d& to,
                     const LineSettings& settings);

/// A waypoint of the tool's tip, as in c4g_protocol.md.
struct TipWaypoint {
  Eigen::Isometry3d tip = Eigen::Isometry3d::Identity();  //!< in base_link [m]
  double speed = 0.05;                                    //!< [m/s] on the way to here
  double zone = 0;            //!< [m] how far from here the tip may leave its lines; 0: it stops
  std::uint32_t outputs = 0;  //!< on from here on
};

/// Lines of the tool's tip from waypoint to waypoint, rounded within their zones, in the posture of
/// `from`. The path begins where the tip stands, at waypoint `first`.
/// @throw ControllerRefusal as plan_line(); if the tip is not at waypoint `first`, two waypoints
/// are the same, or a turn is within 0.1 degree of half a turn
PlannedPath plan_tool_path(const Joints& from, const Eigen::Isometry3d& flange_to_tip,
                           const std::vector<TipWaypoint>& waypoints, std::size_t first,
                           const LineSettings& settings);

/// [m] The largest motion of the flange per way on this path, which is its speed [m/s] at one way
/// per second.
double flange_travel(const Path& path);

/// Joints for a distant pose: the nearest to `near` of the postures within the ranges.
/// @throw ControllerRefusal if it is out of reach or outside the ranges
Joints reach(const Eigen::Isometry3d& flange, const Joints& near);

}  // namespace scan_cell_sim
