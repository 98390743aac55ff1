// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "path_design/trace/waypoints.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace part_recipes {

/// Parameters of all ways to make a path.
struct PathParameters {
  Eigen::Vector3d from = Eigen::Vector3d::UnitZ();  //!< the viewer's direction from the part
  double chord = 0.0001;       //!< [m] from the surface to the line between waypoints
  double max_step = 0.01;      //!< [m] between waypoints
  double stand_off = 0;        //!< [m] of the waypoints from the surface
  std::vector<double> tool_x;  //!< direction of the tool's x axis; empty: along the travel
  path_design::WaypointZ waypoint_z = path_design::WaypointZ::kIntoPart;  //!< of the z axis
  double speed = 0;              //!< [m/s] written as a process value; 0: none
  double gap = 0.002;            //!< [m] narrower holes count as filled
  double min_length = 0;         //!< [m] shorter segments are left out
  double crease_angle = 0.5236;  //!< [rad] of a sharp edge (30 degrees)
  double corner_angle = 0.5236;  //!< [rad] of a corner of the way (30 degrees)
  double leaf = 0.001;           //!< [m] grid on which a cloud is reduced
};

/// Which borders a path follows.
enum class Loops { kAll, kOuter, kHoles };

/// Parameters of a path along the edge of a part or a face.
struct EdgeParameters {
  PathParameters path;        //!< of all paths
  double offset = 0;          //!< [m] inwards from the edge, along the surface
  std::vector<double> near;   //!< [m] on the chosen face; empty: all that is seen
  Loops loops = Loops::kAll;  //!< to follow
  double smoothing = 0;       //!< [m] to each side; 0: four spacings for a cloud, none for a mesh
};

/// How the rows of a raster follow each other.
enum class RasterOrder { kZigzag, kOneWay };

/// Parameters of a raster over a surface.
struct SliceParameters {
  PathParameters path;                       //!< of all paths
  double spacing = 0.005;                    //!< [m] between the planes of the rows
  std::vector<double> direction;             //!< of the rows; empty: the longest axis
  double angle = 0;                          //!< [rad] of the rows from the direction
  RasterOrder order = RasterOrder::kZigzag;  //!< of the rows
  double margin = 0;                         //!< [m] kept from the border
  int border_passes = 0;                     //!< along the border
};

/// Parameters of a path through picked points.
struct PickParameters {
  PathParameters path;          //!< of all paths
  double max_distance = 0.002;  //!< [m] of a pick from the surface
  bool closed = false;          //!< from the last pick back to the first
};

/// Describes each parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, EdgeParameters& parameters);
void describe(scan_cell_common::ParameterTable& table, SliceParameters& parameters);  //!< as above
void describe(scan_cell_common::ParameterTable& table, PickParameters& parameters);   //!< as above

}  // namespace part_recipes
