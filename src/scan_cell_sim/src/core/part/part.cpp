// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/part.h"

#include <Eigen/LU>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_sim {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell_common::UnusableInput;

Vector3d Part::to_world(const Vector3d& point) const {
  return pose * (scale * deformation.apply(point));
}

Vector3d Part::normal_to_world(const Vector3d& point, const Vector3d& normal) const {
  const Matrix3d jacobian = deformation.jacobian(point);
  return (pose.linear() * jacobian.inverse().transpose() * normal).normalized();
}

Vector3d Part::to_part(const Vector3d& world) const {
  return deformation.invert(pose.inverse() * world / scale);
}

Mesh Part::mesh(double tolerance) const {
  Mesh result = tessellate(shape, deformation, tolerance / scale);
  for (Vector3d& vertex : result.vertices) {
    if (!(deformation.jacobian(vertex).determinant() > 0)) {
      throw UnusableInput("part " + name, "its deformation folds it",
                          "make the bulge or the filed edge lower or wider");
    }
    vertex = to_world(vertex);
  }
  return result;
}

Eigen::Isometry3d true_image(const Part& reference, const Part& object,
                             const Eigen::Isometry3d& pose) {
  if (reference.shape.index() != object.shape.index()) {
    throw UnusableInput("parts " + reference.name + " and " + object.name, "different shapes",
                        "give two parts of the same shape");
  }
  const Vector3d point = reference.to_part(pose.translation());
  const Matrix3d to_reference = reference.pose.linear() * reference.deformation.jacobian(point);
  const Matrix3d to_object = object.pose.linear() * object.deformation.jacobian(point);
  const Vector3d normal = to_reference.transpose() * -pose.linear().col(2);
  const Vector3d along = to_object * to_reference.inverse() * pose.linear().col(0);

  const Vector3d z = -object.normal_to_world(point, normal);
  const Vector3d x = (along - z.dot(along) * z).normalized();
  Eigen::Isometry3d image = Eigen::Isometry3d::Identity();
  image.linear() << x, z.cross(x), z;
  image.translation() = object.to_world(point);
  return image;
}

}  // namespace scan_cell_sim
