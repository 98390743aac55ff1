// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "hypotheses.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robust.h"

namespace tool_path_stretcher {
namespace {

/// An even cover of all rotations: the super-Fibonacci spiral (Alexa 2022).
std::vector<Eigen::Matrix3d> even_rotations(int count) {
  const double phi = std::sqrt(2.0);
  constexpr double kPsi = 1.533751168755204288118041;
  std::vector<Eigen::Matrix3d> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5;
    const double inner = std::sqrt(s / count);
    const double outer = std::sqrt(1 - s / count);
    const double alpha = 2 * M_PI * s / phi;
    const double beta = 2 * M_PI * s / kPsi;
    rotations.push_back(Eigen::Quaterniond(outer * std::cos(beta), inner * std::sin(alpha),
                                           inner * std::cos(alpha), outer * std::sin(beta))
                            .normalized()
                            .toRotationMatrix());
  }
  return rotations;
}

}  // namespace

std::vector<Eigen::Matrix3d> cube_turns() {
  std::vector<Eigen::Matrix3d> turns;
  const std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (const auto& order : orders) {
    for (int signs = 0; signs < 8; ++signs) {
      Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
      for (int axis = 0; axis < 3; ++axis)
        turn(order[static_cast<std::size_t>(axis)], axis) = (signs >> axis) & 1 ? -1 : 1;
      if (turn.determinant() > 0) turns.push_back(turn);
    }
  }
  return turns;
}

CoarseSurface coarsen(const Surface& surface) {
  constexpr std::size_t kQueryPoints = 300;
  CoarseSurface coarse;
  const Points dense = select(surface.points, surface.samples.few);
  coarse.frame = principal_frame(dense);
  coarse.queries = select(dense, spread_evenly(dense, kQueryPoints));
  coarse.found = std::make_shared<NearestGrid>(dense);
  return coarse;
}

namespace {

std::vector<Similarity> centred(const std::vector<Eigen::Matrix3d>& rotations,
                                const PrincipalFrame& reference, const PrincipalFrame& object) {
  const double scale = object.deviation.norm() / reference.deviation.norm();
  std::vector<Similarity> guesses;
  for (const Eigen::Matrix3d& rotation : rotations) {
    guesses.push_back({scale, rotation, object.centroid - scale * (rotation * reference.centroid)});
  }
  return guesses;
}

}  // namespace

std::vector<Similarity> principal_guesses(const PrincipalFrame& reference,
                                          const PrincipalFrame& object) {
  std::vector<Eigen::Matrix3d> rotations;
  for (const Eigen::Matrix3d& turn : cube_turns())
    rotations.push_back(object.axes * turn * reference.axes.transpose());
  return centred(rotations, reference, object);
}

std::vector<Similarity> even_guesses(const PrincipalFrame& reference,
                                     const PrincipalFrame& object) {
  constexpr int kVerticalSteps = 24;
  constexpr int kEvenRotations = 144;
  std::vector<Eigen::Matrix3d> rotations = even_rotations(kEvenRotations);
  for (int i = 0; i < kVerticalSteps; ++i) {
    rotations.push_back(Eigen::AngleAxisd(2 * M_PI * i / kVerticalSteps, Eigen::Vector3d::UnitZ())
                            .toRotationMatrix());
  }
  return centred(rotations, reference, object);
}

namespace {

struct Pair {
  std::size_t query;
  std::size_t match;
  double distance;
};

/// Nearest points in the object's frame, the worst left out.
void match(const CoarseSurface& reference, const CoarseSurface& object,
           const Similarity& similarity, std::vector<Pair>& forth, std::vector<Pair>& back) {
  forth.clear();
  back.clear();
  for (std::size_t i = 0; i < object.queries.size(); ++i) {
    const Eigen::Vector3d query = similarity.inverse(object.queries[i]);
    const std::size_t nearest = reference.found->nearest(query);
    forth.push_back(
        {i, nearest, similarity.scale * (reference.found->points()[nearest] - query).norm()});
  }
  for (std::size_t i = 0; i < reference.queries.size(); ++i) {
    const Eigen::Vector3d query = similarity * reference.queries[i];
    const std::size_t nearest = object.found->nearest(query);
    back.push_back({i, nearest, (object.found->points()[nearest] - query).norm()});
  }
  // A scan may show only one side of the reference, but nothing that is not on it.
  constexpr double kObjectShare = 0.9;
  constexpr double kReferenceShare = 0.6;
  const auto keep_nearest = [](std::vector<Pair>& pairs, double share) {
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.query < b.query;
    });
    pairs.resize(static_cast<std::size_t>(std::ceil(share * static_cast<double>(pairs.size()))));
  };
  keep_nearest(forth, kObjectShare);
  keep_nearest(back, kReferenceShare);
}

}  // namespace

namespace {

/// The box of points in a frame turned by `axes` (its columns).
Eigen::AlignedBox3d extent_along(const Eigen::Matrix3d& axes, const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(Eigen::Vector3d(axes.transpose() * point));
  return box;
}

/// Where the middle of `moved` may lie along one axis so that it covers `fixed`.
std::vector<double> middles(double fixed_min, double fixed_max, double moved_length) {
  constexpr double kFilled = 0.93;
  const double length = fixed_max - fixed_min;
  const double middle = (fixed_min + fixed_max) / 2;
  if (length > kFilled * moved_length) return {middle};
  return {fixed_min + moved_length / 2, middle, fixed_max - moved_length / 2};
}

/// All places of the reference, turned and sized, that cover the object's box.
void add_places(const CoarseSurface& reference, const Eigen::Matrix3d& axes,
                const Eigen::AlignedBox3d& object_box, const Eigen::Matrix3d& rotation,
                double scale, std::vector<Similarity>& guesses) {
  const Eigen::Matrix3d turned = axes.transpose() * rotation;
  const Eigen::AlignedBox3d box = extent_along(turned.transpose(), reference.queries);
  const Eigen::Vector3d lengths = scale * box.sizes();
  const Eigen::Vector3d centre = scale * box.center();
  std::array<std::vector<double>, 3> places;
  for (int axis = 0; axis < 3; ++axis) {
    places[static_cast<std::size_t>(axis)] =
        middles(object_box.min()[axis], object_box.max()[axis], lengths[axis]);
  }
  for (const double x : places[0]) {
    for (const double y : places[1]) {
      for (const double z : places[2])
        guesses.push_back({scale, rotation, axes * (Eigen::Vector3d(x, y, z) - centre)});
    }
  }
}

}  // namespace

namespace {

/// The axes along which the points fill the smallest rectangle, seen along the last one. Unlike
/// the principal axes of a plate they stay along its edges where a part of it is missing.
Eigen::Matrix3d rectangle_axes(const Eigen::Matrix3d& axes, const Points& points) {
  constexpr int kSteps = 60;  // of a right angle
  Eigen::Matrix3d best = axes;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::AngleAxisd turn(i * M_PI_2 / kSteps, Eigen::Vector3d::UnitZ());
    const Eigen::Matrix3d turned = axes * turn.toRotationMatrix();
    const Eigen::Vector3d sizes = extent_along(turned, points).sizes();
    if (sizes.x() * sizes.y() >= least) continue;
    least = sizes.x() * sizes.y();
    best = turned;
  }
  return best;
}

/// The reference's axes in all the turns of a cube laid along the object's, sized by each axis.
void add_partial_guesses(const CoarseSurface& reference, const Eigen::Matrix3d& reference_axes,
                         const CoarseSurface& object, const Eigen::Matrix3d& object_axes,
                         std::vector<Similarity>& guesses) {
  constexpr double kThin = 0.05;  // of the longest axis: too short to tell the size
  const Eigen::AlignedBox3d object_box = extent_along(object_axes, object.queries);
  for (const Eigen::Matrix3d& turn : cube_turns()) {
    const Eigen::Matrix3d rotation = object_axes * turn * reference_axes.transpose();
    const Eigen::Vector3d lengths =
        extent_along(rotation.transpose() * object_axes, reference.queries).sizes();
    for (int axis = 0; axis < 3; ++axis) {
      if (lengths[axis] < kThin * lengths.maxCoeff()) continue;
      add_places(reference, object_axes, object_box, rotation,
                 object_box.sizes()[axis] / lengths[axis], guesses);
    }
  }
}

}  // namespace

std::vector<Similarity> partial_guesses(const CoarseSurface& reference, const CoarseSurface& object,
                                        std::size_t most) {
  std::vector<Similarity> guesses;
  add_partial_guesses(reference, reference.frame.axes, object, object.frame.axes, guesses);
  add_partial_guesses(reference, rectangle_axes(reference.frame.axes, reference.queries), object,
                      rectangle_axes(object.frame.axes, object.queries), guesses);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < guesses.size(); ++i)
    order.emplace_back(improve_coarsely(reference, object, guesses[i], {}, 0).cost, i);
  std::sort(order.begin(), order.end());
  std::vector<Similarity> best;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i)
    best.push_back(guesses[order[i].second]);
  return best;
}

Candidate improve_coarsely(const CoarseSurface& reference, const CoarseSurface& object,
                           Similarity guess, const ScaleRange& scales, int iterations) {
  std::vector<Pair> forth;
  std::vector<Pair> back;
  for (int i = 0; i < iterations; ++i) {
    match(reference, object, guess, forth, back);
    Points from;
    Points to;
    for (const Pair& pair : forth) {
      from.push_back(reference.found->points()[pair.match]);
      to.push_back(object.queries[pair.query]);
    }
    for (const Pair& pair : back) {
      from.push_back(reference.queries[pair.query]);
      to.push_back(object.found->points()[pair.match]);
    }
    guess = fit_similarity(from, to, scales);
  }
  match(reference, object, guess, forth, back);
  double squares = 0;
  const auto mean_square = [](const std::vector<Pair>& pairs) {
    double sum = 0;
    for (const Pair& pair : pairs)
      sum += pair.distance * pair.distance;
    return sum / static_cast<double>(pairs.size());
  };
  squares = mean_square(forth) + mean_square(back);
  const double cost = std::sqrt(squares / 2);
  return {guess, cost, cost};
}

Similarity clamped(const Similarity& guess, const ScaleRange& scales,
                   const Eigen::Vector3d& middle) {
  Similarity result = guess;
  result.scale = std::clamp(guess.scale, scales.least, scales.most);
  result.translation = guess * middle - result.scale * (guess.rotation * middle);
  return result;
}

std::vector<Similarity> guesses_about(const Prior& prior, const PrincipalFrame& reference,
                                      const PrincipalFrame& object) {
  const double ratio = object.deviation.norm() / reference.deviation.norm();
  const double scale = prior.scale.is_known() ? prior.scale.value : ratio;
  const Similarity given{scale, prior.pose->pose.linear(), prior.pose->pose.translation()};
  std::vector<Eigen::Matrix3d> rotations = {given.rotation};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double share : {-0.7, 0.7}) {
      const Eigen::AngleAxisd turn(share * prior.pose->angle, Eigen::Vector3d::Unit(axis));
      rotations.push_back(turn * given.rotation);
    }
  }
  std::vector<Similarity> guesses;
  for (const Eigen::Matrix3d& rotation : rotations) {
    for (const Eigen::Vector3d& middle : {given * reference.centroid, object.centroid})
      guesses.push_back({scale, rotation, middle - scale * (rotation * reference.centroid)});
  }
  return guesses;
}

}  // namespace tool_path_stretcher
