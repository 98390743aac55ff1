// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>

#include "mapping/graph_equations.h"
#include "placement/placement.h"

namespace tool_path_stretcher {

/// How far off a mapping may be, anywhere: the posterior covariance of a graph that the scan's
/// points and rims hold, and that strains no more than the part was seen to; and how far the
/// mapping is from where that graph would settle.
class MappingError {
 public:
  /// @param mapping as it was fitted; without a graph, one that does not displace anything is taken
  MappingError(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior);

  struct Covariance {
    Eigen::Matrix3d all;      //!< [m^2, object] of where the mapping puts a point
    Eigen::Matrix3d assumed;  //!< the part of it that no measurement holds down, only a prior
  };
  Covariance at(const Eigen::Vector3d& point) const;

  /// [m^2, object] of each coordinate of a point in the air, beyond that: whether it goes with the
  /// surface, as if it was held by it, or with the space, as the mapping has it, nothing tells. The
  /// two are as far apart as the mapping's derivative makes a lever of that length.
  /// @param base of the reference, nearest to the point
  /// @param slope_variance of the surface over the mapped one
  double lever_variance(const Eigen::Vector3d& point, const Eigen::Vector3d& base,
                        double slope_variance) const;

  /// [m] that all points of a face are off alike, whatever their number
  double common() const { return common_; }

 private:
  /// How a point of the object moves with the unknowns that move it.
  struct Motion {
    std::vector<Eigen::Index> unknowns;
    Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian;
  };
  Motion motion_of(const Eigen::Vector3d& point) const;

  Mapping mapping_;
  Eigen::Vector3d centre_;  // [m, reference] about which the object grows
  Eigen::MatrixXd covariance_;
  Eigen::SparseMatrix<double> assumed_;  // normal equations of all priors
  Eigen::VectorXd pull_;                 // to where the graph would settle
  Eigen::Matrix<double, 6, 6> slack_;    // of rigid motions that only noise seems to hold
  double size_;                          // [m, reference] of the arm of those turns
  double common_;
};

/// Fills in the expected errors of each waypoint.
/// @param path the reference's, of which the placement was made
void expect_errors(const ToolPath& path, const MappingError& mapping_error, Placement& placement);

}  // namespace tool_path_stretcher
