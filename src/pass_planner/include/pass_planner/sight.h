// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "pass_planner/surface.h"
#include "pass_planner/sweep.h"
#include "scan_cell_common/scanner/scanner_model.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace pass_planner {

/// What the scanner can measure; docs/pass_planner.md says where the defaults come from.
struct SightParameters {
  /// [rad] between the surface's normal and the laser's light
  double max_light_angle = 1.22;
  /// [rad] between the surface's normal and the camera's sight
  double max_sight_angle = 1.4;
  double min_range = 0.05;  //!< [m] along the camera's axis, as in laser_triangulation
  double max_range = 5;     //!< [m]
  int region_x = 0;         //!< [px] of the image, as in the camera's node
  int region_y = 0;         //!< [px]
  int region_width = 0;     //!< [px] 0: to the sensor's right edge
  int region_height = 0;    //!< [px] 0: to the sensor's bottom edge
};

/// Describes each parameter: range, unit and meaning. Refuses a min_range above max_range.
void describe(scan_cell_common::ParameterTable& table, SightParameters& parameters);

/// How well a place on the surface is seen, worst first.
enum class Sight { kOutOfRange, kShadowed, kGrazing, kSeen };

/// What is at fault.
enum class Fault {
  kNone,
  kNotPassed,  //!< the laser's plane does not pass over the place
  kDepth,      //!< it does, but the place is too near to the camera, or too far
  kImage,      //!< it does, but the place is outside the image
  kLight,      //!< of the laser
  kSight,      //!< of the camera
};

std::string to_string(Sight sight);  //!< out_of_range, shadowed, grazing, seen
std::string to_string(Fault fault);  //!< none, not_passed, depth, image, light, sight

/// How one sweep sees a place on the surface.
struct Sighting {
  Sight sight = Sight::kOutOfRange;  //!< how well
  Fault fault = Fault::kNotPassed;   //!< what is at fault, where it is not seen
  std::size_t sweep = 0;             //!< index of the sweep
  /// [rad] between normal and light; NaN where the light does not reach the place
  double light_angle = std::numeric_limits<double>::quiet_NaN();
  double sight_angle = std::numeric_limits<double>::quiet_NaN();  //!< [rad] the same of the camera
  /// [m] what stands in the way; the place itself if its own surface lies between light and camera
  std::optional<Eigen::Vector3d> obstacle;
};

/// Whether the first is the better one: of a better kind, or of the same kind at smaller angles.
bool is_better(const Sighting& a, const Sighting& b);

/// Follows sweeps of the scanner over a surface.
class SightCheck {
 public:
  /// @param scanner, surface must outlive it
  /// @throw scan_cell_common::InvalidParameter if the parameters make no sense, or the region lies
  /// outside the sensor
  SightCheck(const scan_cell_common::ScannerModel& scanner, const Surface& surface,
             const SightParameters& parameters);

  /// The best sighting of each place along a sweep. A place is measured when the laser's plane
  /// passes over it.
  /// @param places as Surface::nearest() gives them
  /// @throw scan_cell_common::UnusableInput if the sweep's laser was not calibrated
  /// @throw scan_cell_common::InvalidParameter if the sweep's region lies outside the sensor
  std::vector<Sighting> along(const Sweep& sweep, const std::vector<Surface::Place>& places) const;

 private:
  /// Part of the image in which a line is found.
  struct Window {
    Eigen::Vector2d least;  // [px]
    Eigen::Vector2d most;   // [px]
  };

  Window window_of(const scan_cell::CameraRegion& region, const std::string& name) const;
  Sighting from(const Eigen::Isometry3d& camera, const scan_cell_common::LaserPlane& laser,
                const Surface::Place& place, const Window& window) const;
  Fault outside(const Eigen::Vector3d& in_camera, const Window& window) const;

  const scan_cell_common::ScannerModel& scanner_;
  const Surface& surface_;
  const SightParameters parameters_;
  Window window_;  // of sweeps that have no region of their own
};

/// How a program sees a path.
struct PathSight {
  std::vector<Sweep> sweeps;                     //!< of the program
  std::vector<std::vector<Sighting>> of_sweeps;  //!< of each sweep, for each place
  std::vector<Sighting> best;                    //!< of all sweeps, for each place
  std::size_t count(Sight sight) const;          //!< places seen so at best
  std::vector<std::size_t> not_seen() const;     //!< indices of the places
};

/// @throw as SightCheck::along()
PathSight look_along(const SightCheck& check, std::vector<Sweep> sweeps,
                     const std::vector<Surface::Place>& places);

}  // namespace pass_planner
