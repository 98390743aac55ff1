// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/stretch_parameters.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::Also;
using scan_cell_common::InvalidParameter;
using scan_cell_common::ParameterTable;

const std::vector<std::string> kMethods = {"affine", "general", "thesis_affine", "thesis_general"};

std::vector<double> numbers_of(const std::optional<PosePrior>& prior) {
  if (!prior) return {};
  const Eigen::Vector3d position = prior->pose.translation();
  const Eigen::Vector4d xyzw = Eigen::Quaterniond(prior->pose.linear()).coeffs();
  std::vector<double> numbers(position.begin(), position.end());
  numbers.insert(numbers.end(), xyzw.begin(), xyzw.end());
  return numbers;
}

void describe(ParameterTable& table, ScalePrior& scale) {
  table.add("scale", scale.value, {0.01, 100, "", Also::kZero},
            "known scale; 0: unknown, it is searched");
  table.add("scale_deviation", scale.deviation, {0, 10},
            "standard deviation of the known scale; a scale more than four of them off is "
            "refused; 0: the scale is exact");
  if (scale.value == 0 && scale.deviation != 0) {
    table.refuse("scale_deviation", fmt::format("{:g}", scale.deviation),
                 "give the scale it belongs to as well");
  }
}

void describe(ParameterTable& table, std::optional<PosePrior>& prior) {
  std::vector<double> numbers = numbers_of(prior);
  PosePrior pose = prior.value_or(PosePrior());
  table.add("initial_pose", numbers, {-1e3, 1e3, "m"},
            "known pose, reference to object: x y z qx qy qz qw", 7);
  table.add("initial_pose_angle", pose.angle, {1e-6, M_PI, "rad"},
            "largest error of the rotation in `initial_pose`; poses farther off are not searched");
  table.add("initial_pose_distance", pose.distance, {1e-6, 100, "m"},
            "largest error of `initial_pose` at the reference's centroid");
  if (numbers.empty()) return;
  pose.pose = pose_from_numbers(numbers);
  prior = pose;
}

void describe_size(ParameterTable& table, StretchParameters& p) {
  table.add("min_scale", p.min_scale, {0.01, 100}, "a smaller scale is refused: SCALE_AT_BOUND");
  table.add("max_scale", p.max_scale, {0.01, 100}, "a larger scale is refused: SCALE_AT_BOUND");
  if (p.max_scale < p.min_scale)
    table.refuse("max_scale", fmt::format("{:g}", p.max_scale), "give min_scale or more");
  table.add(
      "scale_range", p.scale_range, {0.001, 0.9},
      "affine, thesis_affine: range searched around the initial scale, 0.15 = +-15 % (r in the "
      "thesis)");
  table.add("scale_steps", p.scale_steps, {1, 1000},
            "affine, thesis_affine: steps to each side (k in the thesis)");
}

void describe_input(ParameterTable& table, StretchParameters& p) {
  table.add("min_points", p.min_points, {50, 1e9},
            "fewest points of each surface after the grid reduction");
  table.add("max_stand_off", p.max_stand_off, {0, 10, "m"},
            "largest distance at which a segment may be led over the surface (median of its "
            "waypoints); a segment led farther off is in the air");
  table.renamed("max_path_distance", "max_stand_off");
  table.add("inlier_distance", p.inlier_distance, {1e-6, 1, "m"},
            "largest distance of a point that counts as explained");
  table.add("min_inlier_ratio", p.min_inlier_ratio, {0, 1},
            "share of the object's points that the reference must explain; if the reference "
            "shows only a part of the object, 95 % of those that it reaches");
  table.add("min_overlap", p.min_overlap, {0, 1},
            "share of the reference's points that the scan must show, or of those that a scan "
            "from its side can show");
  table.add("ambiguity_distance", p.ambiguity_distance, {1e-6, 10, "m"},
            "two poses differ if they put a waypoint this far apart");
}

void describe_deformation(ParameterTable& table, StretchParameters& p) {
  table.add("deformation_level", p.deformation_level, {0, 3}, "finest deformation graph; 0: none");
  table.add("support_radius", p.support_radius, {0, 1, "m"},
            "radius of the scanned points that a waypoint is set on; 0: three spacings of the "
            "scan");
  table.add("min_support", p.min_support, {4, 10000},
            "with fewer points a waypoint is inferred and flagged");
  table.add("max_hole_distance", p.max_hole_distance, {0, 1, "m"},
            "distance from the scan up to which a waypoint is inferred (at least three "
            "spacings); farther than this from the reference (at least two spacings) it is in "
            "the air");
  table.add("tolerance", p.tolerance, {1e-6, 1, "m"},
            "largest distance of an adapted waypoint from the scanned surface (at least a fifth "
            "of the summed spacings of both surfaces)");
  table.add("max_position_error", p.max_position_error, {1e-6, 10, "m"},
            "if the reference is a mesh: largest expected error of a waypoint along the surface, "
            "one standard deviation (at least a fifth of the summed spacings of both surfaces, "
            "and at least initial_pose_distance)");
  table.add("max_orientation_error", p.max_orientation_error, {1e-6, M_PI, "rad"},
            "largest expected error of a waypoint's orientation, one standard deviation");
  table.add("max_deformation_ratio", p.max_deformation_ratio, {1e-6, 1},
            "largest deformation of 95 % of the reference's surface, as a share of the part's "
            "length; above, it is the wrong part");
  table.renamed("max_deformation", "max_deformation_ratio");
  table.add("max_stranger", p.max_stranger, {1e-6, 10, "m"},
            "largest distance from the reference of scanned points over, under or beside a "
            "waypoint; points farther off are in the way, such as a rib or a clamp (at least the "
            "summed spacings of both surfaces)");
  table.add("max_displacement_ratio", p.max_displacement_ratio, {1e-6, 1},
            "largest displacement of a waypoint from where the similarity puts it, as a share of "
            "the part's length");
  table.renamed("max_displacement", "max_displacement_ratio");
}

}  // namespace

std::string to_string(Method method) {
  return kMethods.at(static_cast<std::size_t>(method));
}

Method method_from_string(const std::string& name) {
  scan_cell_common::RangeCheck table;
  std::string word = name;
  table.choice("method", word, kMethods, "");
  return static_cast<Method>(std::find(kMethods.begin(), kMethods.end(), word) - kMethods.begin());
}

void describe(ParameterTable& table, StretchParameters& parameters) {
  table.choice("method", parameters.method, kMethods,
               "affine: one similarity; general: also a smooth deformation; thesis_affine, "
               "thesis_general: as published in the thesis, for comparison");
  table.add("leaf", parameters.leaf, {1e-6, 1, "m"},
            "cell of the grid reduction along x, y, z; enlarged in proportion if more than "
            "50,000 points would be left");
  describe(table, parameters.prior.scale);
  describe(table, parameters.prior.pose);
  table.add("resample_spacing", parameters.resample_spacing, {1e-6, 10, "m", Also::kZero},
            "waypoints are placed at even steps along the path, at most this far apart; the ends "
            "of segments are kept, corners between them are not. 0: the path keeps its waypoints");
  table.choice("stand_off", parameters.stand_off, {"keep", "scale"},
               "segments led over the reference at a constant distance (nine of ten waypoints do "
               "not touch, and the distance varies by less than a fifth) keep it along the "
               "normal, or scale it with the part; a way through the air always scales with the "
               "part");
  describe_size(table, parameters);
  describe_input(table, parameters);
  describe_deformation(table, parameters);
}

void check(const StretchParameters& parameters) {
  if (parameters.prior.pose) {
    const Eigen::Isometry3d& pose = parameters.prior.pose->pose;
    if (!pose.matrix().allFinite() ||
        !(pose.linear() * pose.linear().transpose()).isIdentity(1e-6) ||
        pose.linear().determinant() < 0) {
      throw InvalidParameter("initial_pose", "not a rotation and a translation",
                             "give finite numbers and a unit quaternion");
    }
  }
  scan_cell_common::check(parameters);
}

}  // namespace tool_path_stretcher
