// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <stdexcept>

#include "mapping/graph_equations.h"
#include "surface/surface_pair.h"
#include "tool_path_stretcher/prior.h"
#include "uncertainty/soft_prior.h"

namespace tool_path_stretcher {

/// The inverse of what observations and assumptions hold together; none where they leave an unknown
/// free.
std::optional<Eigen::MatrixXd> posterior_covariance(const Eigen::MatrixXd& information);

/// How far off a mapping may be cannot be told.
struct UnheldMapping : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How far off a mapping may be, anywhere: the posterior covariance of a graph that the scan's
/// points and rims hold, and that strains no more than the part was seen to; and how far the
/// mapping is from where that graph would settle.
class MappingError {
 public:
  /// @param mapping as it was fitted; without a graph, one that does not displace anything is taken
  /// @throws UnheldMapping
  MappingError(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior);

  struct Covariance {
    Eigen::Matrix3d all;      //!< [m^2, object] of where the mapping puts a point
    Eigen::Matrix3d assumed;  //!< the part of it that no measurement holds down, only a prior
  };
  Covariance at(const Eigen::Vector3d& point) const;

  /// [rad^2, object] of how the mapping turns the surface at a point. A part that slides along
  /// itself takes the tool with it: that is in the covariance of its place.
  /// @param turn of the mapping there, as Mapping::turn() has it
  /// @param normal of the reference's surface
  Eigen::Matrix3d of_turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                          const Eigen::Matrix3d& turn) const;

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

  /// How far the nodes that move a point disagree about it: between them the mapping is an
  /// interpolation, which the part need not follow.
  struct Disagreement {
    Eigen::Matrix3d place;  // [m^2, object]
    Eigen::Matrix3d turn;   // [rad^2, object]
  };
  Disagreement disagreement_at(const Eigen::Vector3d& point) const;

  /// The same, of the derivative of its place along a way in the reference's space.
  Motion strain_of(const Eigen::Vector3d& point, const Eigen::Vector3d& way) const;

  Mapping mapping_;
  Eigen::Vector3d centre_;  // [m, reference] about which the object grows
  Eigen::MatrixXd covariance_;
  SoftPrior assumed_;
  Eigen::VectorXd pull_;               // to where the graph would settle
  Eigen::Matrix<double, 6, 6> slack_;  // of rigid motions that only noise seems to hold
  double size_;                        // [m, reference] of the arm of those turns
  double common_;
};

}  // namespace tool_path_stretcher
