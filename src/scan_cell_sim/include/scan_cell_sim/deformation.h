// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

namespace scan_cell_sim {

/// Gaussian hump across one direction, as on a floppy sheet or after a blow.
struct Bulge {
  Eigen::Vector3d centre =
      Eigen::Vector3d::Zero();  //!< [m] its position along `towards` does not matter
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  //!< unit vector, material moves along it
  double radius = 0.03;                                //!< [m] standard deviation of the hump
  double height = 0;                                   //!< [m] at the centre
};

/// Parabolic bend: material moves by curvature / 2 * (along . p)^2.
struct Bend {
  Eigen::Vector3d along = Eigen::Vector3d::UnitX();    //!< unit vector
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  //!< unit vector
  double curvature = 0;                                //!< [1/m]
};

/// A stretch of an edge that was filed down: material moves by depth * exp(-(d / radius)^2 / 2), d
/// being the distance from the line between the two ends.
struct FiledEdge {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();       //!< [m]
  Eigen::Vector3d to = Eigen::Vector3d::UnitX();        //!< [m]
  Eigen::Vector3d towards = -Eigen::Vector3d::UnitZ();  //!< unit vector into the material
  double radius = 0.004;                                //!< [m]
  double depth = 0;                                     //!< [m]
};

/// How a part differs in form from the reference: a smooth field of displacements in the part's own
/// coordinates, the sum of its terms. It gives the new place of each point of the reference's
/// material, on the surface and off it.
class Deformation {
 public:
  using Term = std::variant<Bulge, Bend, FiledEdge>;  //!< one displacement

  void add(const Term& term) { terms_.push_back(term); }  //!< displacements add up
  bool empty() const { return terms_.empty(); }           //!< no displacement

  /// New place of a point [m] of the undeformed part.
  Eigen::Vector3d apply(const Eigen::Vector3d& point) const;

  /// Derivative of apply().
  Eigen::Matrix3d jacobian(const Eigen::Vector3d& point) const;

  /// The point of the undeformed part that moved to `deformed`, by Newton's method.
  /// @throw scan_cell_common::UnusableInput if there is none: the field folds, or the point is far
  /// off
  Eigen::Vector3d invert(const Eigen::Vector3d& deformed) const;

  /// Upper bound [1/m] of all second derivatives of apply() around the point.
  double curvature_bound(const Eigen::Vector3d& point) const;

 private:
  std::vector<Term> terms_;
};

}  // namespace scan_cell_sim
