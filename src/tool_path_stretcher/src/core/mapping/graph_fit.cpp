// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/kd_tree.h"
#include "geometry/nearest_cache.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "mapping/graph_equations.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {
namespace {

using Constraints = std::vector<GraphConstraint>;

/// The scanned points that a graph is fitted to.
struct Target {
  Points points;
  Points normals;
  std::shared_ptr<const KdTree> tree;
};

Target target_of(const Surface& object) {
  return {object.points, object.normals, object.tree};
}

using Anchors = std::vector<GraphAnchor>;

void add_anchor(const DeformationGraph& graph, const Eigen::Vector3d& at,
                const Eigen::Vector3d& along, Anchors& anchors) {
  anchors.push_back({at, along, {}});
  graph.influences(at, anchors.back().influences);
}

Anchors surface_anchors(const Surface& reference, const DeformationGraph& graph, Density density) {
  Anchors anchors;
  for (const std::size_t i : reference.samples.of(density))
    add_anchor(graph, reference.points[i], reference.normals[i], anchors);
  return anchors;
}

Anchors rim_anchors(const Surface& reference, const DeformationGraph& graph) {
  Anchors anchors;
  for (std::size_t i = 0; i < reference.rim.points.size(); ++i)
    add_anchor(graph, reference.rim.points[i], reference.rim.outward[i], anchors);
  return anchors;
}

/// That an anchor should move by `along` [m, object] in a direction of the object's frame.
GraphConstraint constraint_of(const GraphAnchor& anchor, const Eigen::Vector3d& mapped,
                              const Eigen::Vector3d& direction, double along,
                              const Similarity& similarity) {
  return {&anchor, similarity.inverse(mapped + along * direction),
          similarity.rotation.transpose() * direction, along / similarity.scale};
}

constexpr double kFacesAlike = 0.7;  // cosine: up to 46 degrees; chosen

/// From where the mapping puts points of the reference to the scanned surface beside them, along
/// its normal, where the two may be the same place.
Constraints along_normals(const Anchors& anchors, const Surface& object, const Target& target,
                          const Mapping& mapping, NearestCache& in_target) {
  constexpr double kReach = 3;  // spacings; chosen
  Constraints constraints;
  constraints.reserve(anchors.size());
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const GraphAnchor& anchor = anchors[i];
    const Eigen::Vector3d mapped =
        mapping.similarity * mapping.graph.moved(anchor.at, anchor.influences);
    const std::size_t nearest = in_target.nearest(i, mapped);
    const Eigen::Vector3d& normal = target.normals[nearest];
    if (std::abs(normal.dot(mapping.similarity.rotation * anchor.along)) < kFacesAlike) continue;
    const Eigen::Vector3d way = target.points[nearest] - mapped;
    const double along = normal.dot(way);
    if ((way - along * normal).norm() > kReach * object.spacing) continue;
    constraints.push_back(constraint_of(anchor, mapped, normal, along, mapping.similarity));
  }
  return constraints;
}

/// From the reference's rim to the object's, across it.
Constraints along_rims(const Anchors& anchors, const Surface& object, const Mapping& mapping) {
  constexpr double kReach = 0.05;  // of the object's size; chosen
  Constraints constraints;
  if (!object.rim.tree) return constraints;
  for (const GraphAnchor& anchor : anchors) {
    const Eigen::Vector3d mapped =
        mapping.similarity * mapping.graph.moved(anchor.at, anchor.influences);
    const auto nearest = object.rim.tree->nearest(mapped);
    if (nearest.squared_distance > std::pow(kReach * object.size, 2)) continue;
    const Eigen::Vector3d& outward = object.rim.outward[nearest.index];
    if (outward.dot(mapping.similarity.rotation * anchor.along) < kFacesAlike) continue;
    const double along = outward.dot(object.rim.points[nearest.index] - mapped);
    constraints.push_back(constraint_of(anchor, mapped, outward, along, mapping.similarity));
  }
  return constraints;
}

double deviation_of(const Constraints& constraints) {
  std::vector<double> errors;
  errors.reserve(constraints.size());
  for (const GraphConstraint& constraint : constraints)
    errors.push_back(constraint.error);
  return robust_deviation(std::move(errors));
}

/// The same mapping with the object grown about a centre of the reference's space.
void grow(Similarity& similarity, const Eigen::Vector3d& centre, double growth) {
  const Eigen::Vector3d fixed = similarity * centre;
  similarity.scale *= growth;
  similarity.translation = fixed - similarity.scale * (similarity.rotation * centre);
}

/// Fits the graph of a mapping, from where it is.
Mapping fit(const SurfacePair& surfaces, const Target& target, const ScalePrior& scale,
            Density density, Mapping mapping) {
  constexpr int kIterations = 15;        // at most; chosen
  constexpr double kStrain = 0.02;       // of a link's length, one standard deviation; chosen
  constexpr double kConverged = 3e-5;    // of the reference's size; chosen
  constexpr double kExact = 1e-7;        // of the reference's size: a deviation above 0; chosen
  constexpr double kWidest = 0.02;       // of the reference's size; chosen
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  const auto& [reference, object] = surfaces;
  const Eigen::Vector3d centre = principal_frame(reference.points).centroid;
  const Anchors surface = surface_anchors(reference, mapping.graph, density);
  const Anchors rim = rim_anchors(reference, mapping.graph);
  NearestCache in_target(*target.tree, surface.size());
  double widest = kWidest * reference.size;  // a bulge is no outlier before it was followed
  for (int i = 0; i < kIterations; ++i) {
    const Constraints normals = along_normals(surface, object, target, mapping, in_target);
    const Constraints rims = along_rims(rim, object, mapping);
    const double deviation = std::max(deviation_of(normals), kExact * reference.size);
    GraphEquations equations(mapping.graph, centre);
    equations.add(normals, std::max(deviation, widest));
    equations.add(rims, std::max({deviation_of(rims), kRimDeviation * reference.spacing, widest}));
    equations.add_rigidity(kStrain, kStrain);
    equations.add_prior(scale, mapping.similarity.scale);
    const GraphEquations::Step step = equations.solve();
    grow(mapping.similarity, centre, 1 + step.growth);
    take(step, mapping.graph);
    if (step.farthest < kConverged * reference.size && widest < deviation) break;
    widest /= 4;  // chosen
  }
  return mapping;
}

/// The same mapping, with the part of its graph that is a turn and a shift given to the similarity.
Mapping rebased(const Surface& reference, Mapping mapping) {
  const Points from = select(reference.points, reference.samples.few);
  Points to;
  for (const Eigen::Vector3d& point : from)
    to.push_back(point + mapping.graph.displacement(point));
  Similarity rigid = fit_similarity(from, to);
  const Eigen::Vector3d mean = principal_frame(from).centroid;
  const Eigen::Vector3d moved = rigid * mean;
  rigid.scale = 1;
  rigid.translation = moved - rigid.rotation * mean;
  for (DeformationGraph::Node& node : mapping.graph.nodes()) {
    node.shift = rigid.inverse(node.at + node.shift) - node.at;
    node.rotation = rigid.rotation.transpose() * node.rotation;
  }
  Similarity& outer = mapping.similarity;
  outer.translation = outer * rigid.translation;
  outer.rotation = Eigen::Quaterniond(outer.rotation * rigid.rotation).toRotationMatrix();
  return mapping;
}

/// A finer graph that moves its nodes as a coarser mapping does.
Mapping refined(const Surface& reference, const Mapping& coarse, double spacing) {
  Mapping fine{coarse.similarity, DeformationGraph(reference.points, spacing)};
  for (DeformationGraph::Node& node : fine.graph.nodes()) {
    const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + coarse.graph.jacobian(node.at);
    node.rotation = nearest_rotation(local);
    node.shift = coarse.graph.displacement(node.at);
  }
  return fine;
}

using Cell = std::array<long, 3>;

Cell cell_of(const Eigen::Vector3d& point, double edge) {
  const Eigen::Vector3d cell = (point / edge).array().floor();
  return {std::lround(cell.x()), std::lround(cell.y()), std::lround(cell.z())};
}

/// The object in two halves: every other block of a chequerboard in space. Neighbours share their
/// errors, so that single points held out would not tell noise from shape.
struct Halves {
  Target training;
  Points held_out;
  std::vector<std::size_t> block;  // of each point held out
  std::size_t blocks = 0;
};

Halves split_in_blocks(const Surface& object, double edge) {
  const auto trains = [edge](const Eigen::Vector3d& point) {
    const Cell cell = cell_of(point, edge);
    return (cell[0] + cell[1] + cell[2]) % 2 != 0;
  };
  Halves halves;
  for (std::size_t i = 0; i < object.points.size(); ++i) {
    if (!trains(object.points[i])) continue;
    halves.training.points.push_back(object.points[i]);
    halves.training.normals.push_back(object.normals[i]);
  }
  std::map<Cell, std::size_t> numbers;
  for (const std::size_t i : object.samples.many) {
    if (trains(object.points[i])) continue;
    const Cell cell = cell_of(object.points[i], edge);
    halves.block.push_back(numbers.emplace(cell, numbers.size()).first->second);
    halves.held_out.push_back(object.points[i]);
  }
  halves.blocks = numbers.size();
  if (!halves.training.points.empty()) {
    halves.training.tree = std::make_shared<const KdTree>(halves.training.points);
  }
  return halves;
}

/// Whether a scanned point lies beside the reference's surface by little.
bool lies_on_reference(const Residual& residual, const Surface& reference) {
  constexpr double kReach = 2;  // spacings; chosen
  return residual.beside < kReach * reference.spacing;
}

/// Square residuals of the points held out that lie on the reference, each up to the square of
/// `cut`, summed by block.
std::vector<double> held_out_squares(const Surface& reference,
                                     const std::vector<Residual>& residuals, const Halves& halves,
                                     double cut) {
  std::vector<double> sums(halves.blocks, 0);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!lies_on_reference(residuals[i], reference)) continue;
    sums[halves.block[i]] +=
        std::min(residuals[i].along_normal * residuals[i].along_normal, cut * cut);
  }
  return sums;
}

/// Whether the residuals fall by more than a little, and over the whole of the part rather than in
/// one block of it.
bool explains_better(const std::vector<double>& before, const std::vector<double>& after) {
  constexpr double kMinGain = 0.05;      // of the sum of squares; chosen
  constexpr double kSignificance = 1.5;  // standard deviations of the sum over blocks; chosen
  double sum = 0;
  double gain = 0;
  double squares = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    sum += before[i];
    gain += before[i] - after[i];
    squares += std::pow(before[i] - after[i], 2);
  }
  const double mean = gain / static_cast<double>(before.size());
  const double deviation = std::sqrt(squares - mean * gain);
  return gain > kMinGain * sum && gain > kSignificance * deviation;
}

/// Sums over the points of one patch: a cell, and the axis that its normals are nearest to.
struct Patch {
  double count = 0;
  double sum = 0;      // [m]
  double squares = 0;  // [m^2]
};

/// Share of the square residuals that neighbours on the surface have in common, about 0 where they
/// are noise: a smooth deformation can explain no more than that. One-way analysis of variance over
/// patches, each residual counted up to a cut, so that few loose points do not decide.
double common_share(const Surface& reference, const std::vector<Residual>& residuals) {
  constexpr double kCell = 0.12;  // of the reference's size; chosen
  constexpr double kCut = 5;      // robust deviations; chosen
  std::vector<double> along;
  for (const Residual& residual : residuals)
    along.push_back(residual.along_normal);
  const double cut = kCut * robust_deviation(std::move(along));
  std::map<std::pair<Cell, Eigen::Index>, Patch> patches;
  for (const Residual& residual : residuals) {
    if (!lies_on_reference(residual, reference)) continue;
    const Eigen::Vector3d& normal = reference.normals[residual.reference];
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Patch& patch = patches[{cell_of(residual.pulled_back, kCell * reference.size), axis}];
    const double error = std::copysign(1.0, normal[axis]) *  // the sign of a cloud's normal is free
                         std::clamp(residual.along_normal, -cut, cut);
    patch.count += 1;
    patch.sum += error;
    patch.squares += error * error;
  }
  double common = 0;
  double total = 0;
  for (const auto& [at, patch] : patches) {
    total += patch.squares;
    if (patch.count < 2) continue;
    const double of_mean = patch.sum * patch.sum / patch.count;
    common += of_mean - (patch.squares - of_mean) / (patch.count - 1);
  }
  return total > 0 ? common / total : 0;
}

/// Whether so few residuals are more than sampling and grid make of a surface that there is nothing
/// for a graph to explain: those share their errors, too.
bool is_resolved(const Surface& reference, const std::vector<Residual>& residuals,
                 double resolution) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  constexpr double kBlurs = 2;       // the object's, too
  constexpr double kShare = 0.01;    // of the residuals; chosen
  const auto off = std::count_if(residuals.begin(), residuals.end(), [&](const Residual& each) {
    return lies_on_reference(each, reference) &&
           std::abs(each.along_normal) >
               std::max(kDeviations * resolution, kBlurs * reference.blur[each.reference]);
  });
  return static_cast<double>(off) < kShare * static_cast<double>(residuals.size());
}

constexpr double kSpacings[] = {0.9, 0.55, 0.33};  // of the reference's size, by level; chosen

}  // namespace

double graph_spacing(const Surface& reference, int level) {
  return kSpacings[level - 1] * reference.size;
}

GraphObservations observe(const SurfacePair& surfaces, const Mapping& mapping) {
  const auto& [reference, object] = surfaces;
  GraphObservations seen;
  seen.surface = surface_anchors(reference, mapping.graph, Density::kFew);
  seen.rim = rim_anchors(reference, mapping.graph);
  const Target target = target_of(object);
  NearestCache in_target(*target.tree, seen.surface.size());
  seen.normals = along_normals(seen.surface, object, target, mapping, in_target);
  seen.rims = along_rims(seen.rim, object, mapping);
  seen.normal_deviation = deviation_of(seen.normals);
  seen.rim_deviation = deviation_of(seen.rims);
  return seen;
}

namespace {

/// The finest graph that explains the half held out better, fitted to the other half.
Mapping justified_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                              const ScalePrior& scale, int finest_level) {
  constexpr double kBlock = 0.25;     // of the object's size; chosen
  constexpr double kMinCommon = 0.1;  // below, there is nothing for a graph to explain; chosen
  constexpr double kCut = 0.02;       // of the reference's size; chosen
  const auto& [reference, object] = surfaces;
  const Halves halves = split_in_blocks(object, kBlock * object.size);
  const Mapping rigid{similarity, {}};
  if (halves.training.points.empty() || halves.held_out.empty()) return rigid;
  const double cut = kCut * reference.size;
  const std::vector<Residual> at_first = residuals_of(reference, rigid, halves.held_out);
  const double unresolved =
      resolution(surfaces, similarity.scale) / similarity.scale;  // [m, reference]
  if (is_resolved(reference, at_first, unresolved)) return rigid;
  if (common_share(reference, at_first) < kMinCommon) return rigid;
  std::vector<double> best = held_out_squares(reference, at_first, halves, cut);
  Mapping trained = rigid;
  Mapping justified = rigid;
  for (int level = 1; level <= finest_level; ++level) {
    trained = fit(surfaces, halves.training, scale, Density::kSome,
                  refined(reference, trained, graph_spacing(reference, level)));
    const std::vector<double> squares =
        held_out_squares(reference, residuals_of(reference, trained, halves.held_out), halves, cut);
    if (!explains_better(best, squares)) continue;
    best = squares;
    justified = trained;
  }
  return justified;
}

}  // namespace

Mapping fit_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                        const ScalePrior& scale, int finest_level) {
  const Mapping justified = justified_deformation(surfaces, similarity, scale, finest_level);
  if (justified.graph.empty()) return justified;
  return rebased(surfaces.reference,
                 fit(surfaces, target_of(surfaces.object), scale, Density::kMany, justified));
}

Mapping sketch_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                           const ScalePrior& scale, int finest_level) {
  const Mapping justified = justified_deformation(surfaces, similarity, scale, finest_level);
  return justified.graph.empty() ? justified : rebased(surfaces.reference, justified);
}

}  // namespace tool_path_stretcher
