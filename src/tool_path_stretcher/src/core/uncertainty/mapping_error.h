// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include "mapping/graph_equations.h"
#include "surface/surface_pair.h"
#include "tool_path_stretcher/prior.h"
#include "uncertainty/soft_prior.h"

namespace tool_path_stretcher {

/// Thrown if the error of a mapping cannot be determined.
struct UnheldMapping : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The inverse of the information from observations and assumptions.
/// @throws UnheldMapping if they leave an unknown free
Eigen::MatrixXd posterior_covariance(const Eigen::MatrixXd& information);

/// The error of a mapping at any point. It is the posterior covariance of a graph that the scan's
/// points and rims constrain, and that strains no more than the part was seen to, plus the distance
/// of the mapping from where that graph would settle.
class MappingError {
 public:
  /// @param mapping as fitted; without a graph, one that displaces nothing is used
  /// @throws UnheldMapping
  MappingError(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior);

  struct Covariance {
    Eigen::Matrix3d all;      //!< [m^2, object] of the mapped position of a point
    Eigen::Matrix3d assumed;  //!< the part of it that only a prior limits, no measurement
  };
  Covariance at(const Eigen::Vector3d& point) const;

  /// [rad^2, object] of the mapping's rotation of the surface at a point. A part that slides along
  /// itself takes the tool with it: that is in the covariance of the position.
  /// @param turn of the mapping there, from Mapping::turn()
  /// @param normal of the reference's surface
  Eigen::Matrix3d of_turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                          const Eigen::Matrix3d& turn) const;

  /// [m^2, object] additional variance of each coordinate of a point in the air. Nothing tells
  /// whether the point moves with the surface, as if attached to it, or with the space around it,
  /// as in the mapping. The difference is what the mapping's derivative does to a lever of that
  /// length.
  /// @param base nearest point of the reference
  /// @param slope_variance of the scanned surface relative to the mapped one
  double lever_variance(const Eigen::Vector3d& point, const Eigen::Vector3d& base,
                        double slope_variance) const;

  /// [m] common error of all points of a face, whatever their number
  double common() const { return common_; }

 private:
  /// The derivative of an object point with respect to the unknowns that move it.
  struct Motion {
    std::vector<Eigen::Index> unknowns;
    Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian;
  };
  Motion motion_of(const Eigen::Vector3d& point) const;

  /// How far the nodes that move a point disagree about it. Between nodes the mapping is an
  /// interpolation, which the part need not follow.
  struct Disagreement {
    Eigen::Matrix3d place;  // [m^2, object]
    Eigen::Matrix3d turn;   // [rad^2, object]
  };
  Disagreement disagreement_at(const Eigen::Vector3d& point) const;

  /// The same for the derivative of its position along a direction in the reference's space.
  Motion strain_of(const Eigen::Vector3d& point, const Eigen::Vector3d& way) const;

  Mapping mapping_;
  Eigen::Vector3d centre_;  // [m, reference] about which the object grows
  Eigen::MatrixXd covariance_;
  SoftPrior assumed_;
  Eigen::VectorXd pull_;               // towards where the graph would settle
  Eigen::Matrix<double, 6, 6> slack_;  // of rigid motions that only noise seems to constrain
  double size_;                        // [m, reference] lever arm of those rotations
  double common_;
};

}  // namespace tool_path_stretcher
