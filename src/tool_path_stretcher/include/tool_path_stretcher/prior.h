// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// What is known of the object's size before the search. The default: nothing.
struct ScalePrior {
  double value = 0;      //!< 0: nothing is known
  double deviation = 0;  //!< one standard deviation; 0: the scale is exactly that

  bool is_known() const { return value > 0; }                     //!< whether anything is known
  bool is_fixed() const { return is_known() && deviation == 0; }  //!< whether it is exact

  /// Scales within four deviations; all of them where nothing is known.
  ScaleRange range() const;
};

/// What is known of the object's pose before the search, and how far off that may be.
struct PosePrior {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  //!< reference to object
  double angle = M_PI / 6;  //!< [rad] between its rotation and the true one, at most
  double distance = 0.05;   //!< [m] from where it puts the reference's centroid, at most

  /// Whether a similarity is no farther off.
  /// @param centroid of the reference [m]
  bool allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const;
};

/// From where both surfaces were seen: a part that lies on its other side is none.
struct ViewPrior {
  Points of_reference;      //!< unit length, towards the viewers
  Points of_object;         //!< the same
  double angle = M_PI / 6;  //!< [rad] between a direction of the one and one of the other, at most

  /// Whether each direction of the reference, turned so, is one of the object.
  bool allows(const Eigen::Matrix3d& rotation) const;
};

/// @param numbers x y z [m] and qx qy qz qw
/// @throw scan_cell_common::InvalidParameter unless they are seven, with a unit quaternion
Eigen::Isometry3d pose_from_numbers(const std::vector<double>& numbers);

/// What is known before the search. It bounds the search, and decides between poses that the
/// surfaces alone cannot tell apart.
struct Prior {
  ScalePrior scale;                    //!< of the object
  std::optional<PosePrior> pose = {};  //!< none: any pose
  std::optional<ViewPrior> view = {};  //!< none: from any side

  /// Whether a similarity contradicts nothing of it.
  bool allows(const Similarity& similarity, const Eigen::Vector3d& centroid) const;

  /// The same, with more room: what a search may well start from.
  Prior widened(double angle, double distance) const;
};

}  // namespace tool_path_stretcher
