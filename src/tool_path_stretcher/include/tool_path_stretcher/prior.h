// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// Prior knowledge of the object's size. By default, none.
struct ScalePrior {
  double value = 0;      //!< 0: unknown
  double deviation = 0;  //!< one standard deviation; 0: the scale is exact

  bool is_known() const { return value > 0; }                     //!< whether anything is known
  bool is_fixed() const { return is_known() && deviation == 0; }  //!< whether it is exact

  /// Scales within four deviations; all scales if nothing is known.
  ScaleRange range() const;
};

/// Prior knowledge of the object's pose, and its greatest error.
struct PosePrior {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< reference to object
  double angle = M_PI / 6;  //!< [rad] greatest angle between its rotation and the true one
  double distance = 0.05;   //!< [m] greatest error of where it puts the reference's centroid

  /// Whether a similarity lies within these limits.
  /// @param centroid of the reference [m]
  bool allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const;
};

/// The directions from which both surfaces were seen. Rules out a part turned over.
struct ViewPrior {
  Points of_reference;      //!< unit vectors towards the viewers
  Points of_object;         //!< the same
  double angle = M_PI / 6;  //!< [rad] greatest angle between matching directions

  /// Whether each direction of the reference, rotated, matches one of the object's.
  bool allows(const Eigen::Matrix3d& rotation) const;
};

/// @param numbers x y z [m], qx qy qz qw
/// @throw scan_cell_common::InvalidParameter unless there are seven numbers with a unit quaternion
Eigen::Isometry3d pose_from_numbers(const std::vector<double>& numbers);

/// Prior knowledge. It bounds the search, and decides between poses that the surfaces alone cannot
/// tell apart.
struct Prior {
  ScalePrior scale;                    //!< of the object
  std::optional<PosePrior> pose = {};  //!< none: any pose
  std::optional<ViewPrior> view = {};  //!< none: from any side

  /// Whether a similarity is consistent with all of it.
  bool allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const;

  /// The same with wider limits: poses from which a search may start.
  Prior widened(double angle, double distance) const;
};

}  // namespace tool_path_stretcher
