// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "placement/mapping_error.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "geometry/robust.h"

namespace tool_path_stretcher {
namespace {

constexpr Eigen::Index kUnknowns = GraphEquations::kUnknowns;
// Of how far the nodes disagree; calibrated on parts as a line scanner sees them.
constexpr double kInterpolatedPlace = 0.6;
constexpr double kInterpolatedTurn = 0.5;
constexpr double kIndependentRims = 0.1;  // of their points: neighbours along an edge share errors

/// How far the links of a graph are strained, root mean square.
struct Strain {
  double along;   // stretched
  double across;  // bent and sheared
};

/// How far the part may be strained where the scan does not show it: as far as it was seen to be,
/// and a little even where it was not.
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

/// The pose as a whole is known from before, if only to the size of the part: by the mean of the
/// nodes' turns and shifts.
void add_pose(const DeformationGraph& graph, double angle, double distance,
              GraphEquations& equations) {
  const auto nodes = static_cast<Eigen::Index>(graph.nodes().size());
  for (Eigen::Index axis = 0; axis < kUnknowns; ++axis) {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index i = 0; i < nodes; ++i)
      columns.push_back(kUnknowns * i + axis);
    const std::vector<double> shares(columns.size(), 1 / static_cast<double>(nodes));
    equations.add_observation(columns, shares, 0, axis < 3 ? angle : distance);
  }
}

struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right_side;
};

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// One standard deviation of the pose as it is known from before: of the turn [rad] and of the
/// shift [m].
struct PoseDeviation {
  double angle;
  double distance;
};

PoseDeviation pose_deviation(const Surface& reference, const Mapping& mapping, const Prior& prior) {
  constexpr double kAnyAngle = 1;             // [rad] chosen
  const double uniform = 1 / std::sqrt(3.0);  // of what may be anywhere up to a limit
  if (!prior.pose) return {kAnyAngle, reference.size};
  return {std::min(kAnyAngle, uniform * prior.pose->angle),
          std::min(reference.size, uniform * prior.pose->distance / mapping.similarity.scale)};
}

/// What is taken for granted: that the part is stiff, and what was known before.
NormalEquations assumptions(const Mapping& mapping, const Prior& prior, const PoseDeviation& pose,
                            const Eigen::Vector3d& centre) {
  constexpr double kGrowth = 0.5;  // of the scale, one standard deviation; chosen
  const Strain strain = strain_of(mapping.graph);
  GraphEquations equations(mapping.graph, centre);
  equations.add_rigidity(strain.along, strain.across);
  equations.add_prior(prior.scale, mapping.similarity.scale);
  equations.add_observation({equations.matrix().rows() - 1}, {1.0}, 0, kGrowth);
  add_pose(mapping.graph, pose.angle, pose.distance, equations);
  return {equations.matrix().selfadjointView<Eigen::Lower>(), equations.right_side()};
}

/// Replaces the directions of constraints along normals by those of a wider neighbourhood, and says
/// how far off each may still be [rad].
std::vector<double> steady_directions(const Surface& object, const Mapping& mapping,
                                      std::vector<GraphConstraint>& constraints) {
  constexpr double kReach = 4;       // spacings; chosen
  constexpr std::size_t kLeast = 6;  // points; chosen
  constexpr double kSameFace = 0.9;  // cosine: up to 26 degrees; chosen
  const Similarity& outer = mapping.similarity;
  std::vector<KdTree::Neighbour> neighbours;
  std::vector<double> deviations;
  for (GraphConstraint& constraint : constraints) {
    object.tree->within(outer * constraint.target, kReach * object.spacing, neighbours);
    if (neighbours.size() < kLeast) {
      deviations.push_back(1);
      continue;
    }
    Points around;
    for (const KdTree::Neighbour& neighbour : neighbours)
      around.push_back(object.points[neighbour.index]);
    const PrincipalFrame frame = principal_frame(around);
    const Eigen::Vector3d normal = outer.rotation.transpose() * frame.axes.col(2);
    const double agreement = normal.dot(constraint.direction);
    if (std::abs(agreement) > kSameFace) {
      constraint.direction = std::copysign(1.0, agreement) * normal;
    }
    deviations.push_back(frame.deviation[2] / frame.deviation[1] /
                         std::sqrt(static_cast<double>(around.size())));
  }
  return deviations;
}

/// The same for the rims.
std::vector<double> steady_rims(const Surface& object, const Mapping& mapping,
                                std::vector<GraphConstraint>& constraints) {
  constexpr double kReach = 6;  // spacings; chosen
  const Similarity& outer = mapping.similarity;
  std::vector<KdTree::Neighbour> neighbours;
  std::vector<double> deviations;
  for (GraphConstraint& constraint : constraints) {
    object.rim.tree->within(outer * constraint.target, kReach * object.spacing, neighbours);
    const Eigen::Vector3d outward = outer.rotation * constraint.direction;
    Eigen::Vector3d sum = outward;
    double count = 1;
    for (const KdTree::Neighbour& neighbour : neighbours) {
      const Eigen::Vector3d& other = object.rim.outward[neighbour.index];
      if (other.dot(outward) <= 0) continue;
      sum += other;
      count += 1;
    }
    constraint.direction = outer.rotation.transpose() * sum.normalized();
    deviations.push_back(std::sqrt(2 * std::max(0.0, 1 - sum.norm() / count) / count));
  }
  return deviations;
}

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Motions = Eigen::Matrix<double, 3, 6>;

/// The centre of turns [m, reference], and the arm that makes a turn as long as a shift [m].
struct Turns {
  Eigen::Vector3d centre;
  double size;
};

/// How a point moves with a turn (of a point at the arm's length by one metre) and a shift.
Motions rigid_motions(const Eigen::Vector3d& point, const Turns& turns) {
  Motions motions;
  for (int axis = 0; axis < 3; ++axis) {
    motions.col(axis) = Eigen::Vector3d::Unit(axis).cross(point - turns.centre) / turns.size;
    motions.col(3 + axis) = Eigen::Vector3d::Unit(axis);
  }
  return motions;
}

/// What constraints of one kind hold of the rigid motions.
struct Held {
  Matrix6d all = Matrix6d::Zero();       // if each direction was exact
  Matrix6d steadily = Matrix6d::Zero();  // of the steady ones
  Matrix6d noise = Matrix6d::Zero();     // of those, what their noise holds
};

/// Directions that are far less steady than most, as beside edges and in loose points, are not
/// taken to hold anything.
/// @param off [rad] how far each direction may be off
Held held_by(const std::vector<GraphConstraint>& constraints, const std::vector<double>& off,
             double weight, const Turns& turns) {
  constexpr double kSteady = 3;  // times the median; chosen
  Held held;
  const double most = kSteady * quantile(off, 0.5);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Motions motions = rigid_motions(constraints[i].target, turns);
    const Vector6d along = motions.transpose() * constraints[i].direction;
    const Matrix6d one = weight * along * along.transpose();
    held.all += one;
    if (off[i] > most) continue;
    held.steadily += one;
    held.noise += std::pow(off[i], 2) * (weight * motions.transpose() * motions - one);
  }
  return held;
}

Matrix6d beyond_noise(const Matrix6d& steadily, const Matrix6d& noise) {
  constexpr double kShared = 4;  // neighbouring normals share points, so tilts do not average out
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(steadily - kShared * noise);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// What the covariance of the rigid motions is short of, because the noise of the normals seems to
/// hold what nothing holds: a moulding's normals all lie in one plane, and noise tilts them out of
/// it. Edges of a mesh hold what they hold whatever the normals do; where a scan ends may be no
/// edge.
/// @param pose as it was known before
Matrix6d seemingly_held(const Held& normals, const Held& rims, bool edges_are_known,
                        const Turns& turns, const PoseDeviation& pose) {
  const Matrix6d really =
      edges_are_known ? Matrix6d(beyond_noise(normals.steadily, normals.noise) +
                                 beyond_noise(rims.steadily, rims.noise))
                      : beyond_noise(normals.steadily + rims.steadily, normals.noise + rims.noise);
  Vector6d known;  // [m] deviations of the motions from before
  known << Eigen::Vector3d::Constant(pose.angle * turns.size),
      Eigen::Vector3d::Constant(pose.distance);
  const Matrix6d prior = known.cwiseAbs2().cwiseInverse().asDiagonal();
  return Matrix6d((really + prior).inverse() - (normals.all + rims.all + prior).inverse());
}

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

MappingError::MappingError(const SurfacePair& surfaces, const Mapping& mapping, const Prior& prior)
    : mapping_(mapping), centre_(principal_frame(surfaces.reference.points).centroid) {
  constexpr int kLevel = 2;              // where no graph was justified; chosen
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
  // The anchors looked at stand for all those that the mapping was fitted to.
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
  const NormalEquations assumed = assumptions(mapping_, prior, pose, centre_);
  const NormalEquations measured = measurements(mapping_, seen, share, centre_);
  const Eigen::MatrixXd all = assumed.matrix + measured.matrix;
  covariance_ = all.llt().solve(Eigen::MatrixXd::Identity(all.rows(), all.cols()));
  assumed_ = assumed.matrix.sparseView();
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
  const Eigen::MatrixXd spread =
      covariance_(Eigen::all, motion.unknowns) * motion.jacobian.transpose();
  const Eigen::Vector3d pull = motion.jacobian * pull_(motion.unknowns);
  Covariance result;
  result.all = motion.jacobian * spread(motion.unknowns, Eigen::all) + pull * pull.transpose();
  result.assumed = spread.transpose() * (assumed_ * spread);
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
  // Two tangents tell how a surface turns: about each of them by how the other one rises, and about
  // the normal by half of how far they turn to each other.
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
