// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pass_planner/sight.h"

namespace pass_planner {

/// [m] from each place to the nearest scanned point; infinite if there is none.
std::vector<double> distances(const std::vector<Eigen::Vector3d>& places,
                              const std::vector<Eigen::Vector3d>& scan);

/// The simulated cell's image, and no angle that is too grazing.
SightParameters any_angle_in_the_cell();

/// What was predicted for waypoints, and what the simulated scan then gave.
struct Agreement {
  std::size_t seen = 0;              //!< waypoints said to be seen
  std::size_t seen_and_there = 0;    //!< of these, with a scanned point within 1 mm
  std::size_t hidden = 0;            //!< waypoints said to be shadowed or out of range
  std::size_t hidden_and_gone = 0;   //!< of these, without such a point
  std::size_t grazing = 0;           //!< said to be at too grazing an angle: measured poorly or not
  std::size_t grazing_and_gone = 0;  //!< of these, without such a point
};

/// Scans drawn parts along drawn lines.
/// @param scanner its model's file
Agreement measure_agreement(const std::string& scanner, std::uint64_t first_seed, int parts);

/// How well a face is measured that is turned away from the light or from the camera.
struct FaceAtAngle {
  double light_angle = 0;  //!< [rad] to the normal
  double sight_angle = 0;  //!< [rad] to the normal
  double measured = 0;     //!< share of the face's places with a scanned point within 1 mm
  double rms = 0;          //!< [m] of those points from the face
};

/// Scans a leaning face with laser_0, whose light comes from one side.
/// @param lean [rad] of the face towards the light (above 0), or away from it
/// @param roll [rad] of the face about the direction of travel
FaceAtAngle measure_face(const std::string& scanner, double lean, double roll);

}  // namespace pass_planner
