// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

namespace tool_path_programs {

/// An arc as G-code gives it, in the plane normal to an axis.
struct GcodeArc {
  Eigen::Index normal = 2;                           //!< of X Y Z: that of G17 is Z
  bool clockwise = false;                            //!< G2, seen against the normal
  Eigen::Vector3d from;                              //!< [mm]
  Eigen::Vector3d to;                                //!< [mm]
  std::optional<Eigen::Vector3d> centre_from_start;  //!< I J K [mm]
  std::optional<double> radius;                      //!< R [mm]; below 0: the longer way
};

/// The point in the middle of an arc.
/// @return none if there is no such arc, it is a whole circle, or it leaves its plane
std::optional<Eigen::Vector3d> middle_of(const GcodeArc& arc);

}  // namespace tool_path_programs
