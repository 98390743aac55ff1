// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "search/hypotheses.h"

#include <algorithm>
#include <cmath>

#include "geometry/robust.h"

namespace tool_path_stretcher {

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
  coarse.normals = select(surface.normals, surface.samples.few);
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
