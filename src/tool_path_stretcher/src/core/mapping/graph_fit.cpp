// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "cores/by_index.h"
#include "geometry/facing.h"
#include "geometry/kd_tree.h"
#include "geometry/nearest_cache.h"
#include "geometry/points.h"
#include "geometry/robust.h"
#include "mapping/graph_equations.h"
#include "mapping/trial.h"
#include "surface/edges.h"

namespace tool_path_stretcher {
namespace {

using Constraints = std::vector<GraphConstraint>;

/// How fine and how stiff a graph is.
struct GraphKind {
  double spacing;  //!< of graph_spacing()
  double along;    //!< strain of a link, one standard deviation: stretched
  double across;   //!< the same: bent and sheared
};

/// For parts that bend far more easily than they stretch, as most do; chosen. On a straight
/// moulding nothing else holds the material between two corners: the normals all lie in one plane,
/// and the noise that tilts them out of it would let the material slide along.
constexpr GraphKind kBending = {0.7, 0.002, 0.02};
/// For parts that also swell; chosen.
constexpr GraphKind kSwelling = {1, 0.02, 0.02};

Target target_of(const Surface& object) {
  return {object.points, object.normals, object.tree};
}

using Anchors = std::vector<GraphAnchor>;

GraphAnchor anchor_of(const DeformationGraph& graph, const Eigen::Vector3d& at,
                      const Eigen::Vector3d& along) {
  GraphAnchor anchor{at, along, {}};
  graph.influences(at, anchor.influences);
  return anchor;
}

Anchors surface_anchors(const Surface& reference, const DeformationGraph& graph, Density density) {
  const std::vector<std::size_t>& sample = reference.samples.of(density);
  return by_index<GraphAnchor>(sample.size(), kHundreds, [&](std::size_t k) {
    return anchor_of(graph, reference.points[sample[k]], reference.normals[sample[k]]);
  });
}

Anchors rim_anchors(const Surface& reference, const DeformationGraph& graph) {
  const Rim& rim = reference.edges;
  return all_of<GraphAnchor>(rim.points.size(), kHundreds,
                             [&](std::size_t i) -> std::optional<GraphAnchor> {
                               if (rim.horizon[i]) return {};
                               return anchor_of(graph, rim.points[i], rim.outward[i]);
                             });
}

/// The constraint that an anchor should move by `along` [m, object] in a direction given in the
/// object's frame.
GraphConstraint constraint_of(const GraphAnchor& anchor, const Eigen::Vector3d& mapped,
                              const Eigen::Vector3d& direction, double along,
                              const Similarity& similarity) {
  return {&anchor, similarity.inverse(mapped + along * direction),
          similarity.rotation.transpose() * direction, along / similarity.scale};
}

constexpr double kFacesAlike = 0.7;  // cosine: up to 46 degrees; chosen

/// Constraints from mapped points of the reference to the scanned surface beside them, along its
/// normal, if the two may be the same place.
Constraints along_normals(const Anchors& anchors, const Surface& object, const Target& target,
                          const Mapping& mapping, NearestCache& in_target) {
  constexpr double kReach = 3;  // spacings; chosen
  const auto of_anchor = [&](std::size_t i) -> std::optional<GraphConstraint> {
    const GraphAnchor& anchor = anchors[i];
    const Eigen::Vector3d mapped =
        mapping.similarity * mapping.graph.moved(anchor.at, anchor.influences);
    const std::size_t nearest = in_target.nearest(i, mapped);
    const Eigen::Vector3d& normal = target.normals[nearest];
    if (std::abs(normal.dot(mapping.similarity.rotation * anchor.along)) < kFacesAlike) return {};
    const Eigen::Vector3d way = target.points[nearest] - mapped;
    const double along = normal.dot(way);
    if ((way - along * normal).norm() > kReach * object.spacing) return {};
    return constraint_of(anchor, mapped, normal, along, mapping.similarity);
  };
  return all_of<GraphConstraint>(anchors.size(), kHundreds, of_anchor);
}

/// Constraints from the reference's edges to the object's, across them.
Constraints along_rims(const Anchors& anchors, const Surface& object, const Mapping& mapping) {
  constexpr double kReach = 0.05;  // of the object's size; chosen
  if (!object.edges.tree) return {};
  const auto of_anchor = [&](std::size_t i) -> std::optional<GraphConstraint> {
    const GraphAnchor& anchor = anchors[i];
    const Eigen::Vector3d mapped =
        mapping.similarity * mapping.graph.moved(anchor.at, anchor.influences);
    const auto nearest =
        edge_facing(object.edges, mapped, mapping.similarity.rotation * anchor.along);
    if (!nearest || (object.edges.points[*nearest] - mapped).norm() > kReach * object.size)
      return {};
    const Eigen::Vector3d& outward = object.edges.outward[*nearest];
    const double along = outward.dot(object.edges.points[*nearest] - mapped);
    return constraint_of(anchor, mapped, outward, along, mapping.similarity);
  };
  return all_of<GraphConstraint>(anchors.size(), kHundreds, of_anchor);
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

/// Fits the graph of a mapping, starting from its current state.
/// @param still share of the residuals' deviation: nodes that move less have settled
Mapping fit(const SurfacePair& surfaces, const Target& target, const ScalePrior& scale,
            Density density, const GraphKind& kind, double still, Mapping mapping) {
  constexpr int kIterations = 15;        // at most; chosen
  constexpr double kConverged = 3e-5;    // of the reference's size; chosen
  constexpr double kExact = 1e-7;        // of the reference's size: a deviation above 0; chosen
  constexpr double kWidest = 0.02;       // of the reference's size; chosen
  constexpr double kRimDeviation = 0.5;  // spacings: how far inside its rim a surface is sampled
  const auto& [reference, object] = surfaces;
  const Eigen::Vector3d centre = reference.centroid;
  const Anchors surface = surface_anchors(reference, mapping.graph, density);
  const Anchors rim = rim_anchors(reference, mapping.graph);
  NearestCache in_target(*target.tree, surface.size(), object.spacing);
  const Eigen::Matrix3d axes =
      principal_frame(select(reference.points, reference.samples.few)).axes;
  const auto way_of = [](const GraphConstraint& rim) -> const Eigen::Vector3d& {
    return rim.direction;
  };
  double widest = kWidest * reference.size;  // a bulge is not an outlier until it is followed
  for (int i = 0; i < kIterations; ++i) {
    const Constraints normals = along_normals(surface, object, target, mapping, in_target);
    const Constraints rims = along_rims(rim, object, mapping);
    const double deviation = std::max(deviation_of(normals), kExact * reference.size);
    GraphEquations equations(mapping.graph, centre);
    equations.add(normals, std::max(deviation, widest));
    for (const Constraints& facing : by_facing(rims, axes, way_of))
      equations.add(facing,
                    std::max({deviation_of(facing), kRimDeviation * reference.spacing, widest}));
    equations.add_rigidity(kind.along, kind.across);
    equations.add_prior(scale, mapping.similarity.scale);
    const GraphEquations::Step step = equations.solve();
    grow(mapping.similarity, centre, 1 + step.growth);
    take(step, mapping.graph);
    const double rest = std::max(kConverged * reference.size, still * deviation);
    if (step.farthest < rest && widest < deviation) break;
    widest /= 4;  // chosen
  }
  return mapping;
}

/// The same mapping, with the rigid part of its graph moved into the similarity.
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

/// A finer graph whose nodes move as in a coarser mapping.
Mapping refined(const Surface& reference, const Mapping& coarse, double spacing) {
  Mapping fine{coarse.similarity, DeformationGraph(reference.points, spacing)};
  for (DeformationGraph::Node& node : fine.graph.nodes()) {
    const Eigen::Matrix3d local = Eigen::Matrix3d::Identity() + coarse.graph.jacobian(node.at);
    node.rotation = nearest_rotation(local);
    node.shift = coarse.graph.displacement(node.at);
  }
  return fine;
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
  NearestCache in_target(*target.tree, seen.surface.size(), object.spacing);
  seen.normals = along_normals(seen.surface, object, target, mapping, in_target);
  seen.rims = along_rims(seen.rim, object, mapping);
  seen.normal_deviation = deviation_of(seen.normals);
  seen.rim_deviation = deviation_of(seen.rims);
  return seen;
}

namespace {

/// [m^2] mean square distance between the rims of both surfaces
double rim_square(const SurfacePair& surfaces, const Mapping& mapping) {
  const Constraints rims =
      along_rims(rim_anchors(surfaces.reference, mapping.graph), surfaces.object, mapping);
  double sum = 0;
  for (const GraphConstraint& each : rims)
    sum += each.error * each.error;
  return rims.empty() ? 0 : sum / static_cast<double>(rims.size());
}

/// A mapping, and the squares of a trial that remain under it.
struct Justified {
  Mapping mapping;
  std::vector<double> squares;
};

/// The finest graph of a kind that explains the held-out half better, fitted to the other half.
Justified justified_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                                const ScalePrior& scale, int finest_level, const GraphKind& kind,
                                const Trial& trial) {
  constexpr double kStill = 0.1;  // changes no squared residual by more than 1 %; chosen
  const Surface& reference = surfaces.reference;
  Mapping trained{similarity, {}};
  Justified justified{trained, trial.squares};
  if (trial.squares.empty()) return justified;
  for (int level = 1; level <= finest_level; ++level) {
    const double spacing = kind.spacing * graph_spacing(reference, level);
    trained = fit(surfaces, trial.halves.training, scale, Density::kSome, kind, kStill,
                  refined(reference, trained, spacing));
    const std::vector<double> squares = held_out_squares(reference, trained, trial);
    if (explains_better(justified.squares, squares)) justified = {trained, squares};
  }
  return justified;
}

/// Whether a part swelled and did not only bend. The held-out half shows it, or the rims if the
/// surface may slide along itself.
bool swelled(const SurfacePair& surfaces, const Justified& bent, const Justified& swollen) {
  constexpr double kMinGain = 0.3;  // of the mean square at the rims; chosen
  if (swollen.mapping.graph.empty()) return false;
  return bent.mapping.graph.empty() || explains_better(bent.squares, swollen.squares) ||
         rim_square(surfaces, swollen.mapping) <
             (1 - kMinGain) * rim_square(surfaces, bent.mapping);
}

}  // namespace

Mapping fit_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                        const ScalePrior& scale, int finest_level) {
  const Trial trial = trial_of(surfaces, similarity);
  const auto justified = by_index<Justified>(2, kSingly, [&](std::size_t i) {
    return justified_deformation(surfaces, similarity, scale, finest_level,
                                 i == 0 ? kBending : kSwelling, trial);
  });
  const bool has_swelled = swelled(surfaces, justified[0], justified[1]);
  const Mapping& best = justified[has_swelled ? 1 : 0].mapping;
  if (best.graph.empty()) return best;
  return rebased(surfaces.reference,
                 fit(surfaces, target_of(surfaces.object), scale, Density::kMany,
                     has_swelled ? kSwelling : kBending, 0, best));
}

Mapping sketch_deformation(const SurfacePair& surfaces, const Similarity& similarity,
                           const ScalePrior& scale, int finest_level) {
  const Mapping mapping = justified_deformation(surfaces, similarity, scale, finest_level,
                                                kSwelling, trial_of(surfaces, similarity))
                              .mapping;
  return mapping.graph.empty() ? mapping : rebased(surfaces.reference, mapping);
}

}  // namespace tool_path_stretcher
