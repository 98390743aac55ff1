// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/mapping_error.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "geometry/points.h"
#include "uncertainty/slack.h"
#include "uncertainty/steady_directions.h"

namespace tool_path_stretcher {
namespace {

constexpr Eigen::Index kUnknowns = GraphEquations::kUnknowns;
// Factors for the disagreement of the nodes; calibrated on parts as a line scanner sees them.
constexpr double kInterpolatedPlace = 0.6;
constexpr double kInterpolatedTurn = 0.5;
constexpr double kIndependentRims = 0.1;  // of their points: neighbours along an edge share errors

NormalEquations measurements(const Mapping& mapping, const GraphObservations& seen, double share,
                             const Eigen::Vector3d& centre) {
  GraphEquations normals(mapping.graph, centre);
  normals.add(seen.normals, seen.normal_deviation);
  GraphEquations rims(mapping.graph, centre);
  rims.add(seen.rims, seen.rim_deviation);
  const Eigen::MatrixXd matrix = share * normals.matrix() + kIndependentRims * rims.matrix();
  return {matrix.selfadjointView<Eigen::Lower>(),
          share * normals.right_side() + kIndependentRims * rims.right_side()};
}

}  // namespace

Eigen::MatrixXd posterior_covariance(const Eigen::MatrixXd& information) {
  const Eigen::LLT<Eigen::MatrixXd> factor(information);
  if (factor.info() == Eigen::Success) {
    Eigen::MatrixXd covariance =
        factor.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
    if (covariance.allFinite()) return covariance;
  }
  throw UnheldMapping(
      fmt::format("the equations of the mapping's {} unknowns are singular", information.rows()));
}

MappingError::MappingError(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior)
    : mapping_(mapping), centre_(principal_frame(surfaces.reference.points).centroid) {
  constexpr int kLevel = 2;              // if no graph was justified; chosen
  constexpr double kExact = 1e-6;        // of the size: a deviation above 0; chosen
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  constexpr double kIndependent = 0.25;  // of the points: neighbours share errors; chosen
  constexpr double kCommon = 0.05;       // of the noise: shared by all points of a face; chosen
  const auto& [reference, object] = surfaces;
  if (mapping_.graph.empty()) {
    mapping_.graph = DeformationGraph(reference.points, graph_spacing(reference, kLevel));
  }
  GraphObservations seen = observe(surfaces, mapping_);
  seen.normal_deviation = std::max(seen.normal_deviation, kExact * reference.size);
  seen.rim_deviation = std::max(seen.rim_deviation, kRimDeviation * reference.spacing);
  // The sampled anchors stand for all those that the mapping was fitted to.
  const double share = kIndependent * static_cast<double>(reference.samples.many.size()) /
                       static_cast<double>(reference.samples.few.size());
  const PoseDeviation pose = pose_deviation(reference, mapping, prior);
  size_ = reference.size;
  const Turns turns{centre_, size_};
  const double rim_share = reference.oriented ? kIndependentRims : 1;
  const std::vector<double> unsteady = steady_directions(object, mapping_, seen.normals);
  const std::vector<double> unsteady_rims = steady_rims(object, mapping_, seen.rims);
  slack_ = seemingly_held(
      held_by(seen.normals, unsteady, share / std::pow(seen.normal_deviation, 2), turns),
      held_by(seen.rims, unsteady_rims, rim_share / std::pow(seen.rim_deviation, 2), turns),
      reference.oriented, turns, pose);
  // A part that was not seen to be deformed is as stiff as its links.
  const bool is_deformed = !mapping.graph.empty();
  assumed_ = SoftPrior(knowledge(mapping_, prior, pose, centre_), rigidity(mapping_, centre_),
                       is_deformed ? smooth_modes(mapping_.graph) : Eigen::MatrixXd(),
                       mapping_.graph.links().size());
  const NormalEquations assumed = assumed_.equations();
  const NormalEquations measured = measurements(mapping_, seen, share, centre_);
  covariance_ = posterior_covariance(assumed.matrix + measured.matrix);
  pull_ = covariance_ * (assumed.right_side + measured.right_side);
  common_ = kCommon * mapping.similarity.scale * seen.normal_deviation;
}

MappingError::Motion MappingError::motion_of(const Eigen::Vector3d& point) const {
  const DeformationGraph& graph = mapping_.graph;
  std::vector<DeformationGraph::Influence> influences;
  graph.influences(point, influences);
  Motion motion;
  motion.jacobian.resize(3, kUnknowns * static_cast<Eigen::Index>(influences.size()) + 1);
  Eigen::Index column = 0;
  for (const auto& influence : influences) {
    const DeformationGraph::Node& node = graph.nodes()[influence.node];
    const Eigen::Vector3d arm = node.rotation * (point - node.at);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
      motion.jacobian.col(column + axis) = influence.weight * unit.cross(arm);
      motion.jacobian.col(column + 3 + axis) = influence.weight * unit;
    }
    for (Eigen::Index i = 0; i < kUnknowns; ++i)
      motion.unknowns.push_back(kUnknowns * static_cast<Eigen::Index>(influence.node) + i);
    column += kUnknowns;
  }
  motion.jacobian.col(column) = graph.moved(point, influences) - centre_;
  motion.unknowns.push_back(covariance_.rows() - 1);
  motion.jacobian = mapping_.similarity.scale * mapping_.similarity.rotation * motion.jacobian;
  return motion;
}

MappingError::Covariance MappingError::at(const Eigen::Vector3d& point) const {
  const Motion motion = motion_of(point);
  const Eigen::Matrix<double, Eigen::Dynamic, 3> spread =
      covariance_(Eigen::all, motion.unknowns) * motion.jacobian.transpose();
  const Eigen::Vector3d pull = motion.jacobian * pull_(motion.unknowns);
  Covariance result;
  result.all = motion.jacobian * spread(motion.unknowns, Eigen::all) + pull * pull.transpose();
  result.assumed = assumed_.held(spread);
  const Similarity& outer = mapping_.similarity;
  const Motions rigid = outer.scale * outer.rotation * rigid_motions(point, {centre_, size_});
  const Eigen::Matrix3d slack = rigid * slack_ * rigid.transpose();
  result.all += slack + kInterpolatedPlace * kInterpolatedPlace * disagreement_at(point).place;
  result.assumed += slack;
  return result;
}

MappingError::Disagreement MappingError::disagreement_at(const Eigen::Vector3d& point) const {
  const DeformationGraph& graph = mapping_.graph;
  std::vector<DeformationGraph::Influence> influences;
  graph.influences(point, influences);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& influence : influences)
    sum += influence.weight * graph.nodes()[influence.node].rotation;
  const Eigen::Matrix3d mean = nearest_rotation(sum);
  const Eigen::Vector3d at = graph.moved(point, influences);
  Disagreement result{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero()};
  for (const auto& influence : influences) {
    const DeformationGraph::Node& node = graph.nodes()[influence.node];
    const Eigen::Vector3d off = node.rotation * (point - node.at) + node.at + node.shift - at;
    const Eigen::AngleAxisd between(node.rotation * mean.transpose());
    const Eigen::Vector3d turn = between.angle() * between.axis();
    result.place += influence.weight * off * off.transpose();
    result.turn += influence.weight * turn * turn.transpose();
  }
  const Similarity& outer = mapping_.similarity;
  result.place =
      std::pow(outer.scale, 2) * outer.rotation * result.place * outer.rotation.transpose();
  result.turn = outer.rotation * result.turn * outer.rotation.transpose();
  return result;
}

MappingError::Motion MappingError::strain_of(const Eigen::Vector3d& point,
                                             const Eigen::Vector3d& way) const {
  const DeformationGraph& graph = mapping_.graph;
  std::vector<DeformationGraph::Influence> influences;
  graph.influences(point, influences);
  const std::vector<double> slopes = graph.weight_slopes(point, way, influences);
  Motion motion;
  motion.jacobian.resize(3, kUnknowns * static_cast<Eigen::Index>(influences.size()));
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < influences.size(); ++i) {
    const DeformationGraph::Node& node = graph.nodes()[influences[i].node];
    const Eigen::Vector3d arm =
        node.rotation * (influences[i].weight * way + slopes[i] * (point - node.at));
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
      motion.jacobian.col(column + axis) = unit.cross(arm);
      motion.jacobian.col(column + 3 + axis) = slopes[i] * unit;
    }
    for (Eigen::Index k = 0; k < kUnknowns; ++k)
      motion.unknowns.push_back(kUnknowns * static_cast<Eigen::Index>(influences[i].node) + k);
    column += kUnknowns;
  }
  motion.jacobian = mapping_.similarity.rotation * motion.jacobian;
  return motion;
}

Eigen::Matrix3d MappingError::of_turn(const Eigen::Vector3d& point, const Eigen::Vector3d& normal,
                                      const Eigen::Matrix3d& turn) const {
  const Eigen::Vector3d tangent = normal.unitOrthogonal();
  const Eigen::Vector3d bitangent = normal.cross(tangent);
  const Motion along = strain_of(point, tangent);
  const Motion across = strain_of(point, bitangent);
  const Eigen::Vector3d one = turn * tangent;
  const Eigen::Vector3d other = turn * bitangent;
  const Eigen::Vector3d upward = turn * normal;
  // Two tangents tell how a surface rotates: about each of them, by how the other one rises; about
  // the normal, by half of how far they rotate relative to each other.
  const Eigen::Matrix<double, 3, Eigen::Dynamic> turning =
      one * (upward.transpose() * across.jacobian) - other * (upward.transpose() * along.jacobian) +
      0.5 * upward * (other.transpose() * along.jacobian - one.transpose() * across.jacobian);
  const Eigen::Vector3d pull = turning * pull_(along.unknowns);
  return turning * covariance_(along.unknowns, along.unknowns) * turning.transpose() +
         pull * pull.transpose() +
         kInterpolatedTurn * kInterpolatedTurn * disagreement_at(point).turn;
}

double MappingError::lever_variance(const Eigen::Vector3d& point, const Eigen::Vector3d& base,
                                    double slope_variance) const {
  constexpr double kAxes = 3;
  const double lever = mapping_.similarity.scale * (point - base).norm();
  return lever * lever * (mapping_.graph.jacobian(base).squaredNorm() / kAxes + slope_variance);
}

}  // namespace tool_path_stretcher
