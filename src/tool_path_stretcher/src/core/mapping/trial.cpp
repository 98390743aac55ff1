// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/robust.h"
#include "mapping/residuals.h"

namespace tool_path_stretcher {
namespace {

using Cell = std::array<long, 3>;

Cell cell_of(const Eigen::Vector3d& point, double edge) {
  const Eigen::Vector3d cell = (point / edge).array().floor();
  return {std::lround(cell.x()), std::lround(cell.y()), std::lround(cell.z())};
}

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

/// Whether a scanned point lies close to the reference's surface laterally.
bool lies_on_reference(const Residual& residual, const Surface& reference) {
  constexpr double kReach = 2;  // spacings; chosen
  return residual.beside < kReach * reference.spacing;
}

std::vector<double> squares_of(const Surface& reference, const std::vector<Residual>& residuals,
                               const Trial& trial) {
  const Halves& halves = trial.halves;
  const double cut = trial.cut;
  std::vector<double> sums(halves.blocks, 0);
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (!lies_on_reference(residuals[i], reference)) continue;
    sums[halves.block[i]] +=
        std::min(residuals[i].along_normal * residuals[i].along_normal, cut * cut);
  }
  return sums;
}

/// Sums over the points of one patch: a cell and the axis nearest to its normals.
struct Patch {
  double count = 0;
  double sum = 0;      // [m]
  double squares = 0;  // [m^2]
};

/// Share of the squared residuals that neighbours on the surface have in common; about 0 for noise.
/// A smooth deformation can explain no more than that. One-way analysis of variance over patches,
/// each residual capped, so that a few loose points do not decide.
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
    const double error = std::copysign(1.0, normal[axis]) *  // a cloud's normal has any sign
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

/// Whether so few residuals exceed the errors of sampling and grid that there is nothing for a
/// graph to explain. Neighbours share these errors too.
bool is_resolved(const Surface& reference, const std::vector<Residual>& residuals,
                 double resolution) {
  constexpr double kDeviations = 3;  // standard: 0.3 % of normal noise
  constexpr double kBlurs = 2;       // includes the object's
  constexpr double kShare = 0.01;    // of the residuals; chosen
  const auto off = std::count_if(residuals.begin(), residuals.end(), [&](const Residual& each) {
    return lies_on_reference(each, reference) &&
           std::abs(each.along_normal) >
               std::max(kDeviations * resolution, kBlurs * reference.blur[each.reference]);
  });
  return static_cast<double>(off) < kShare * static_cast<double>(residuals.size());
}

}  // namespace

Trial trial_of(const SurfacePair& surfaces, const Similarity& similarity) {
  constexpr double kBlock = 0.25;     // of the object's size; chosen
  constexpr double kCut = 0.02;       // of the reference's size; chosen
  constexpr double kMinCommon = 0.1;  // below: nothing for a graph to explain; chosen
  const auto& [reference, object] = surfaces;
  Trial trial{split_in_blocks(object, kBlock * object.size), kCut * reference.size, {}};
  if (trial.halves.training.points.empty() || trial.halves.held_out.empty()) return trial;
  const std::vector<Residual> at_first =
      residuals_of(reference, {similarity, {}}, trial.halves.held_out);
  const double unresolved =
      resolution(surfaces, similarity.scale) / similarity.scale;  // [m, reference]
  if (!is_resolved(reference, at_first, unresolved) &&
      common_share(reference, at_first) >= kMinCommon)
    trial.squares = squares_of(reference, at_first, trial);
  return trial;
}

std::vector<double> held_out_squares(const Surface& reference, const Mapping& mapping,
                                     const Trial& trial) {
  return squares_of(reference, residuals_of(reference, mapping, trial.halves.held_out), trial);
}

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

}  // namespace tool_path_stretcher
