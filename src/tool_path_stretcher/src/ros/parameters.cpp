// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include <limits>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/ros/parameter_reader.h"

namespace tool_path_stretcher {

namespace {

void read_initial_pose(scan_cell_common::ParameterReader& reader, Prior& prior) {
  using Range = scan_cell_common::ParameterReader::Range;
  std::vector<double> numbers;
  PosePrior pose;
  reader.read("initial_pose", numbers, Range{-1e3, 1e3});
  reader.read("initial_pose_angle", pose.angle, Range{1e-6, M_PI});
  reader.read("initial_pose_distance", pose.distance, Range{1e-6, 100});
  if (numbers.empty()) return;
  pose.pose = pose_from_numbers(numbers);
  prior.pose = pose;
}

}  // namespace

StretchParameters load_parameters(const ros::NodeHandle& private_node) {
  using Range = scan_cell_common::ParameterReader::Range;
  scan_cell_common::ParameterReader reader(private_node);
  StretchParameters p;

  std::string method = to_string(p.method);
  reader.read_choice("method", method, {"affine", "general"});
  p.method = method_from_string(method);
  std::vector<double> leaf = {p.leaf.x(), p.leaf.y(), p.leaf.z()};
  reader.read("leaf", leaf, Range{1e-6, 1});
  if (leaf.size() != 3) {
    throw scan_cell_common::InvalidParameter(private_node.resolveName("leaf"),
                                             std::to_string(leaf.size()) + " numbers",
                                             "give three: x, y and z in metres");
  }
  p.leaf = Eigen::Vector3d(leaf[0], leaf[1], leaf[2]);
  reader.read("scale", p.prior.scale.value, Range{0, 100});
  reader.read("scale_deviation", p.prior.scale.deviation, Range{0, 10});
  read_initial_pose(reader, p.prior);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  reader.read("resample_spacing", p.resample_spacing, Range{-kInfinite, kInfinite});
  check_resample_spacing(private_node.resolveName("resample_spacing"), p.resample_spacing);
  std::string stand_off = to_string(p.stand_off);
  reader.read_choice("stand_off", stand_off, {"keep", "scale"});
  p.stand_off = stand_off_from_string(stand_off);
  reader.read("min_scale", p.min_scale, Range{0.01, 100});
  reader.read("max_scale", p.max_scale, Range{0.01, 100});
  reader.read("scale_range", p.scale_range, Range{0.001, 0.9});
  reader.read("scale_steps", p.scale_steps, Range{1, 1000});
  reader.read("min_points", p.min_points, Range{50, 1e9});
  reader.read("max_path_distance", p.max_path_distance, Range{0, 10});
  reader.read("inlier_distance", p.inlier_distance, Range{1e-6, 1});
  reader.read("min_inlier_ratio", p.min_inlier_ratio, Range{0, 1});
  reader.read("min_overlap", p.min_overlap, Range{0, 1});
  reader.read("ambiguity_distance", p.ambiguity_distance, Range{1e-6, 10});
  reader.read("deformation_level", p.deformation_level, Range{0, 3});
  reader.read("support_radius", p.support_radius, Range{0, 1});
  reader.read("min_support", p.min_support, Range{4, 10000});
  reader.read("max_hole_distance", p.max_hole_distance, Range{0, 1});
  reader.read("tolerance", p.tolerance, Range{1e-6, 1});
  reader.read("max_deformation", p.max_deformation, Range{1e-6, 10});
  reader.read("max_stranger", p.max_stranger, Range{1e-6, 10});
  reader.read("max_displacement", p.max_displacement, Range{1e-6, 10});
  reader.refuse_unknown();
  check(p);
  return p;
}

}  // namespace tool_path_stretcher
