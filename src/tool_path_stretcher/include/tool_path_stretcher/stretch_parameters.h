// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "tool_path_stretcher/prior.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace tool_path_stretcher {

/// The thesis' two methods (9.2 and 9.7), corrected and as it writes them.
enum class Method {
  kAffine,         //!< one similarity, its scale searched
  kGeneral,        //!< similarity, smooth deformation, waypoints set on the scanned surface
  kThesisAffine,   //!< RANSAC over scales about that of the principal axes
  kThesisGeneral,  //!< ICP with that scale, then the nearest points of the object
};

std::string to_string(Method method);  //!< as parameters write it

/// @throw scan_cell_common::InvalidParameter if it is none of them
Method method_from_string(const std::string& name);

/// What becomes of the distance of a path that does not touch the surface.
enum class StandOff {
  kKeep,   //!< it stays as long as it is, along the normal: it belongs to the process
  kScale,  //!< it grows with the part
};

/// Of stretch(); docs/tool_path_stretcher.md says what each does.
struct StretchParameters {
  Method method = Method::kGeneral;               //!< how the path is mapped
  Eigen::Vector3d leaf = {0.002, 0.002, 0.0005};  //!< [m] grid reduction after loading
  Prior prior;                                    //!< what is known of size and pose before
  double min_scale = 0.45;                        //!< beyond: kScaleAtBound
  double max_scale = 2.2;                         //!< beyond: kScaleAtBound
  double scale_range =
      0.15;              //!< affine, thesis_affine: searched about the initial scale, 0.15 = +-15 %
  int scale_steps = 15;  //!< affine, thesis_affine: to each side
  int min_points = 200;  //!< of each surface after reduction
  double resample_spacing = 0;           //!< [m] along the path; 0: its own waypoints
  StandOff stand_off = StandOff::kKeep;  //!< of a path that does not touch the surface
  double max_stand_off = 0.02;           //!< [m] of a segment over the surface; beyond: in the air
  double inlier_distance = 0.002;        //!< [m] of a point that counts as explained
  double min_inlier_ratio = 0.8;         //!< of the object's points, or it is the wrong part
  double min_overlap = 0.3;              //!< of the reference's points, or it is the wrong part
  double ambiguity_distance = 0.001;  //!< [m] two poses differ if they put a waypoint so far apart
  int deformation_level = 3;          //!< finest deformation graph, of 3; 0: none
  double support_radius = 0;          //!< [m] 0: from the object's spacing
  int min_support = 6;                //!< points; with fewer a waypoint is inferred
  double max_hole_distance = 0.01;    //!< [m] from the scan, up to which a waypoint may be inferred
  double tolerance = 0.002;           //!< [m] of an adapted waypoint from the scanned surface
  double max_position_error = 0.005;  //!< [m] expected along the surface, one deviation
  double max_orientation_error = 0.087;  //!< [rad] expected of a waypoint, one deviation (5 deg)
  /// Of 95 % of the surface, as a share of the part's length (12 mm of 400 mm), or it is the wrong
  /// part.
  double max_deformation_ratio = 0.03;
  double max_stranger = 0.004;  //!< [m] that the scan beside a waypoint may be off the reference
  /// Of a waypoint from where the similarity puts it, as a share of the part's length (20 mm of 400
  /// mm).
  double max_displacement_ratio = 0.05;
};

/// All parameters with range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, StretchParameters& parameters);

/// @throw scan_cell_common::InvalidParameter naming what is out of range
void check(const StretchParameters& parameters);

}  // namespace tool_path_stretcher
