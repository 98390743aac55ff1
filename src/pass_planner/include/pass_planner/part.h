// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "pass_planner/surface.h"

namespace pass_planner {

/// The files of a part that is to be scanned.
struct PartFiles {
  std::string reference;         //!< mesh or cloud
  std::string path;              //!< tool path on the reference: CSV or YAML
  std::string report;            //!< from stretch: where the part lies; empty: as in its file
  double reference_metres = 1;   //!< per unit of the reference's file
  std::string path_units = "m";  //!< of the path's file: m, mm or inch
};

/// A part and the waypoints on it, in the frame of the scan program.
struct PlacedPart {
  SurfaceShape shape;                      //!< [m]
  std::vector<Eigen::Vector3d> waypoints;  //!< [m] over all segments
  std::vector<std::size_t> wanted;  //!< those to be seen: those that the report names, or all
};

/// Reads the files of a part. With a report of stretch, shape and waypoints are moved by its
/// similarity onto the scanned object, and the waypoints that it names are wanted.
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput, also if the report is about
/// other files or has no pose
PlacedPart load_part(const PartFiles& files);

/// The places on the surface nearest to the waypoints.
/// @throw scan_cell_common::UnusableInput if a waypoint is farther than 20 mm off the surface
std::vector<Surface::Place> places_of(const std::vector<Eigen::Vector3d>& waypoints,
                                      const Surface& surface);

/// The same for some of the waypoints.
/// @param wanted their indices
std::vector<Surface::Place> places_of(const std::vector<Eigen::Vector3d>& waypoints,
                                      const Surface& surface,
                                      const std::vector<std::size_t>& wanted);

}  // namespace pass_planner
