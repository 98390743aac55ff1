// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/assumptions.h"

#include <algorithm>
#include <cmath>

namespace tool_path_stretcher {
namespace {

constexpr Eigen::Index kNodeUnknowns = GraphEquations::kUnknowns;

/// RMS strain of a graph's links.
struct Strain {
  double along;   // stretched
  double across;  // bent and sheared
};

/// The strain that the part may have where the scan does not show it: the strain seen, and at least
/// a little.
Strain strain_of(const DeformationGraph& graph) {
  constexpr double kMinAlong = 5e-4;   // of a length; chosen
  constexpr double kMinAcross = 2e-3;  // of a length; chosen
  constexpr double kWithin = 3;        // strain between two nodes over that of links; chosen
  double along = 0;
  double across = 0;
  double count = 1;
  for (const auto& [one, other] : graph.links()) {
    const DeformationGraph::Node& from = graph.nodes()[one];
    const DeformationGraph::Node& to = graph.nodes()[other];
    const Eigen::Vector3d way = to.at - from.at;
    const Eigen::Vector3d moved = way + to.shift - from.shift;
    const Eigen::Vector3d error = moved - from.rotation * way;
    along += std::pow(moved.norm() / way.norm() - 1, 2);
    across += error.squaredNorm() / way.squaredNorm() / 2;
    count += 1;
  }
  return {std::max(kMinAlong, kWithin * std::sqrt(along / count)),
          std::max(kMinAcross, std::sqrt(across / count))};
}

/// Adds the prior of the overall pose, if only to the size of the part, through the mean of the
/// nodes' rotations and shifts.
void add_pose(const DeformationGraph& graph, double angle, double distance,
              GraphEquations& equations) {
  const auto nodes = static_cast<Eigen::Index>(graph.nodes().size());
  for (Eigen::Index axis = 0; axis < kNodeUnknowns; ++axis) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < nodes; ++i)
      columns.push_back(kNodeUnknowns * i + axis);
    const std::vector<double> shares(columns.size(), 1 / static_cast<double>(nodes));
    equations.add_observation(columns, shares, 0, axis < 3 ? angle : distance);
  }
}

NormalEquations normal_equations(const GraphEquations& equations) {
  return {equations.matrix().selfadjointView<Eigen::Lower>(), equations.right_side()};
}

}  // namespace

PoseDeviation pose_deviation(const Surface& reference, const Mapping& mapping, const Prior& prior) {
  constexpr double kAnyAngle = 1;             // [rad] chosen
  const double uniform = 1 / std::sqrt(3.0);  // for a uniform distribution up to a limit
  if (!prior.pose) return {kAnyAngle, reference.size};
  return {std::min(kAnyAngle, uniform * prior.pose->angle),
          std::min(reference.size, uniform * prior.pose->distance / mapping.similarity.scale)};
}

NormalEquations knowledge(const Mapping& mapping, const Prior& prior, const PoseDeviation& pose,
                          const Eigen::Vector3d& centre) {
  constexpr double kGrowth = 0.5;  // of the scale, one standard deviation; chosen
  GraphEquations equations(mapping.graph, centre);
  equations.add_prior(prior.scale, mapping.similarity.scale);
  equations.add_observation({equations.matrix().rows() - 1}, {1.0}, 0, kGrowth);
  add_pose(mapping.graph, pose.angle, pose.distance, equations);
  return normal_equations(equations);
}

NormalEquations rigidity(const Mapping& mapping, const Eigen::Vector3d& centre) {
  const Strain strain = strain_of(mapping.graph);
  GraphEquations equations(mapping.graph, centre);
  equations.add_rigidity(strain.along, strain.across);
  return normal_equations(equations);
}

}  // namespace tool_path_stretcher
