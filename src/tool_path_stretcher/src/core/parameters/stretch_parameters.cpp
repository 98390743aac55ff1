// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/stretch_parameters.h"

#include <Eigen/LU>
#include <cmath>
#include <sstream>

#include "scan_cell_common/errors.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::InvalidParameter;

void check_range(const std::string& name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  const auto text = [](double number) {
    std::ostringstream out;
    out << number;
    return out.str();
  };
  throw InvalidParameter(name, text(value),
                         "give a value from " + text(least) + " to " + text(most));
}

}  // namespace

std::string to_string(Method method) {
  return method == Method::kAffine ? "affine" : "general";
}

Method method_from_string(const std::string& name) {
  if (name == "affine") return Method::kAffine;
  if (name == "general") return Method::kGeneral;
  throw InvalidParameter("method", "'" + name + "'", "give affine or general");
}

std::string to_string(StandOff stand_off) {
  return stand_off == StandOff::kKeep ? "keep" : "scale";
}

StandOff stand_off_from_string(const std::string& name) {
  if (name == "keep") return StandOff::kKeep;
  if (name == "scale") return StandOff::kScale;
  throw InvalidParameter("stand_off", "'" + name + "'", "give keep or scale");
}

namespace {

void check(const Prior& prior) {
  const ScalePrior& scale = prior.scale;
  if (scale.value != 0) check_range("scale", scale.value, 0.01, 100);
  check_range("scale_deviation", scale.deviation, 0, 10);
  if (scale.value == 0 && scale.deviation != 0) {
    throw InvalidParameter("scale_deviation", std::to_string(scale.deviation),
                           "give the scale that deviates so far too");
  }
  if (!prior.pose) return;
  const Eigen::Isometry3d& pose = prior.pose->pose;
  if (!pose.matrix().allFinite() || !(pose.linear() * pose.linear().transpose()).isIdentity(1e-6) ||
      pose.linear().determinant() < 0) {
    throw InvalidParameter("initial_pose", "not a rotation and a translation",
                           "give finite numbers and a unit quaternion");
  }
  check_range("initial_pose_angle", prior.pose->angle, 1e-6, M_PI);
  check_range("initial_pose_distance", prior.pose->distance, 1e-6, 100);
}

}  // namespace

void check(const StretchParameters& parameters) {
  check(parameters.prior);
  check_resample_spacing("resample_spacing", parameters.resample_spacing);
  for (const double leaf : parameters.leaf)
    check_range("leaf", leaf, 1e-6, 1);
  check_range("min_scale", parameters.min_scale, 0.01, 100);
  check_range("max_scale", parameters.max_scale, parameters.min_scale, 100);
  check_range("scale_range", parameters.scale_range, 0.001, 0.9);
  check_range("scale_steps", parameters.scale_steps, 1, 1000);
  check_range("min_points", parameters.min_points, 50, 1e9);
  check_range("max_path_distance", parameters.max_path_distance, 0, 10);
  check_range("inlier_distance", parameters.inlier_distance, 1e-6, 1);
  check_range("min_inlier_ratio", parameters.min_inlier_ratio, 0, 1);
  check_range("min_overlap", parameters.min_overlap, 0, 1);
  check_range("ambiguity_distance", parameters.ambiguity_distance, 1e-6, 10);
  check_range("deformation_level", parameters.deformation_level, 0, 3);
  check_range("support_radius", parameters.support_radius, 0, 1);
  check_range("min_support", parameters.min_support, 4, 10000);
  check_range("max_hole_distance", parameters.max_hole_distance, 0, 1);
  check_range("tolerance", parameters.tolerance, 1e-6, 1);
  check_range("max_deformation", parameters.max_deformation, 1e-6, 10);
  check_range("max_stranger", parameters.max_stranger, 1e-6, 10);
  check_range("max_displacement", parameters.max_displacement, 1e-6, 10);
}

}  // namespace tool_path_stretcher
