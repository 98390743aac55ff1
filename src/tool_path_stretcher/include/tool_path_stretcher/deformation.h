// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// A smooth displacement of the reference, in its own frame: each component is a polynomial in the
/// coordinates along the reference's principal axes, of full degree in the two long ones and at
/// most linear in the short one. What the data do not show stays zero.
class SmoothField {
 public:
  SmoothField() = default;  ///< no displacement

  /// @param degree 1 (affine) to 4
  SmoothField(const PrincipalFrame& frame, int degree);

  int degree() const { return degree_; }
  std::size_t terms() const { return powers_.size(); }

  Eigen::Vector3d displacement(const Eigen::Vector3d& point) const;
  Eigen::Matrix3d jacobian(const Eigen::Vector3d& point) const;  ///< of the displacement

  /// Values of the polynomial's terms at a point.
  void basis(const Eigen::Vector3d& point, Eigen::VectorXd& values) const;

  /// 3 x terms: the displacement is coefficients * basis [m]
  Eigen::Matrix3Xd& coefficients() { return coefficients_; }

 private:
  struct Powers {
    int x, y, z;
  };

  Eigen::Vector3d normalised(const Eigen::Vector3d& point) const;

  int degree_ = 0;
  Eigen::Vector3d centroid_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d to_axes_ = Eigen::Matrix3d::Identity();  // rotates and divides by the extent
  std::vector<Powers> powers_;
  Eigen::Matrix3Xd coefficients_;
};

/// Reference to object: p_object = similarity * (p + field(p)).
struct Mapping {
  Similarity similarity;
  SmoothField field;

  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const {
    return similarity * (point + field.displacement(point));
  }

  /// The point of the reference's space that comes to lie on `point` of the object's.
  Eigen::Vector3d pull_back(const Eigen::Vector3d& point) const;

  /// How the surface with that normal at a point of the reference is turned: by the rotation
  /// nearest to the mapping's derivative, then so that the normal stays normal to the surface.
  Eigen::Matrix3d turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const;
};

/// Follows a smooth deformation of the object, where one is there: fields of rising degree are
/// fitted to one half of the scan (in blocks) and kept only while they explain the other half
/// better, so that noise is not followed. No field if none does; otherwise the similarity is the
/// one nearest to the whole mapping.
Mapping fit_smooth_field(const Surface& reference, const Surface& object,
                         const Similarity& similarity, int highest_degree);

}  // namespace tool_path_stretcher
