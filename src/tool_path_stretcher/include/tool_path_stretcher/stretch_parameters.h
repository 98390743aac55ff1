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

/// The thesis' two methods (9.2 and 9.7), corrected and as published.
enum class Method {
  kAffine,         //!< one similarity, scale found by search
  kGeneral,        //!< similarity, smooth deformation, waypoints set on the scanned surface
  kThesisAffine,   //!< RANSAC over scales around that of the principal axes
  kThesisGeneral,  //!< ICP at that scale, then the object's nearest points
};

std::string to_string(Method method);  //!< as written in parameters

/// @throw scan_cell_common::InvalidParameter if there is no such method
Method method_from_string(const std::string& name);

/// How to treat the distance of a path that does not touch the surface.
enum class StandOff {
  kKeep,   //!< keeps its length along the normal: it belongs to the process
  kScale,  //!< scales with the part
};

/// Parameters of stretch(); see docs/tool_path_stretcher.md.
struct StretchParameters {
  Method method = Method::kGeneral;               //!< how the path is mapped
  Eigen::Vector3d leaf = {0.002, 0.002, 0.0005};  //!< [m] grid reduction after loading
  Prior prior;                                    //!< prior knowledge of size and pose
  double min_scale = 0.45;                        //!< beyond: kScaleAtBound
  double max_scale = 2.2;                         //!< beyond: kScaleAtBound
  double scale_range =
      0.15;  //!< affine, thesis_affine: searched around the initial scale, 0.15 = +-15 %
  int scale_steps = 15;                  //!< affine, thesis_affine: to each side
  int min_points = 200;                  //!< of each surface after reduction
  double resample_spacing = 0;           //!< [m] along the path; 0: keep its waypoints
  StandOff stand_off = StandOff::kKeep;  //!< of a path that does not touch the surface
  double max_stand_off = 0.02;     //!< [m] of a segment over the surface; farther off: in the air
  double inlier_distance = 0.002;  //!< [m] greatest distance of an explained point
  double min_inlier_ratio = 0.8;   //!< of the object's points, or it is the wrong part
  double min_overlap = 0.3;        //!< of the reference's points, or it is the wrong part
  double ambiguity_distance = 0.001;  //!< [m] two poses differ if a waypoint differs by this much
  int deformation_level = 3;          //!< finest deformation graph, 1 to 3; 0: none
  double support_radius = 0;          //!< [m] 0: from the object's spacing
  int min_support = 6;                //!< points; with fewer, a waypoint is inferred
  double max_hole_distance = 0.01;  //!< [m] from the scan, within which a waypoint may be inferred
  double tolerance = 0.002;  //!< [m] distance of an adapted waypoint from the scanned surface
  double max_position_error = 0.005;     //!< [m] expected along the surface, one standard deviation
  double max_orientation_error = 0.087;  //!< [rad] expected, one standard deviation (5 deg)
  /// Deformation of 95 % of the surface, as a share of the part's length (12 mm of 400 mm); above:
  /// wrong part.
  double max_deformation_ratio = 0.03;
  double max_stranger = 0.004;  //!< [m] distance of the scan beside a waypoint from the reference
  /// Displacement of a waypoint from where the similarity puts it, as a share of the part's length
  /// (20 mm of 400 mm).
  double max_displacement_ratio = 0.05;
};

/// Describes every parameter: range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, StretchParameters& parameters);

/// @throw scan_cell_common::InvalidParameter naming the parameter that is out of range
void check(const StretchParameters& parameters);

}  // namespace tool_path_stretcher
