// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

#include "tool_path_stretcher/deformation.h"

namespace tool_path_stretcher {

SmoothField::SmoothField(const PrincipalFrame& frame, int degree)
    : degree_(degree), centroid_(frame.centroid) {
  constexpr double kExtent = 2;  // standard deviations: most points come to lie within +-1
  // One length for all axes: a thin part must not make its short axis weigh more.
  to_axes_ = frame.axes.transpose() / (kExtent * frame.deviation[0]);
  for (int z = 0; z <= 1; ++z) {
    for (int sum = 0; sum + z <= degree; ++sum) {
      for (int y = 0; y <= sum; ++y)
        powers_.push_back({sum - y, y, z});
    }
  }
  coefficients_ = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(powers_.size()));
}

Eigen::Vector3d SmoothField::normalised(const Eigen::Vector3d& point) const {
  return to_axes_ * (point - centroid_);
}

namespace {

double power(double base, int exponent) {
  double result = 1;
  for (int i = 0; i < exponent; ++i)
    result *= base;
  return result;
}

double derivative(double base, int exponent) {
  return exponent == 0 ? 0 : exponent * power(base, exponent - 1);
}

}  // namespace

void SmoothField::basis(const Eigen::Vector3d& point, Eigen::VectorXd& values) const {
  const Eigen::Vector3d at = normalised(point);
  values.resize(static_cast<Eigen::Index>(powers_.size()));
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const Powers& p = powers_[k];
    values[static_cast<Eigen::Index>(k)] =
        power(at.x(), p.x) * power(at.y(), p.y) * power(at.z(), p.z);
  }
}

Eigen::Vector3d SmoothField::displacement(const Eigen::Vector3d& point) const {
  if (powers_.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d at = normalised(point);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const Powers& p = powers_[k];
    sum += coefficients_.col(static_cast<Eigen::Index>(k)) *
           (power(at.x(), p.x) * power(at.y(), p.y) * power(at.z(), p.z));
  }
  return sum;
}

Eigen::Matrix3d SmoothField::jacobian(const Eigen::Vector3d& point) const {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  if (powers_.empty()) return sum;
  const Eigen::Vector3d at = normalised(point);
  for (std::size_t k = 0; k < powers_.size(); ++k) {
    const Powers& p = powers_[k];
    const Eigen::RowVector3d slope(
        derivative(at.x(), p.x) * power(at.y(), p.y) * power(at.z(), p.z),
        power(at.x(), p.x) * derivative(at.y(), p.y) * power(at.z(), p.z),
        power(at.x(), p.x) * power(at.y(), p.y) * derivative(at.z(), p.z));
    sum += coefficients_.col(static_cast<Eigen::Index>(k)) * slope;
  }
  return sum * to_axes_;
}

Eigen::Vector3d Mapping::pull_back(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d target = similarity.inverse(point);
  if (field.terms() == 0) return target;
  constexpr int kIterations = 4;  // the field is smooth and small: each gains one to two digits
  Eigen::Vector3d result = target;
  for (int i = 0; i < kIterations; ++i)
    result = target - field.displacement(result);
  return result;
}

Eigen::Matrix3d Mapping::turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) const {
  if (field.terms() == 0) return similarity.rotation;
  const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + field.jacobian(point);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(local, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d handed = Eigen::Matrix3d::Identity();
  handed(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Eigen::Matrix3d nearest = svd.matrixU() * handed * svd.matrixV().transpose();
  // A shear turns a surface further than the rotation nearest to it.
  const Eigen::Vector3d turned = local.inverse().transpose() * normal;
  const auto rest = Eigen::Quaterniond::FromTwoVectors(nearest * normal, turned);
  return similarity.rotation * rest.toRotationMatrix() * nearest;
}

}  // namespace tool_path_stretcher
