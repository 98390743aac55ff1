// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/points.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/geometry/even_cells.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::Grid;
using scan_cell_common::GridEntry;

Grid grid_of(const Eigen::Vector3d& leaf) {
  constexpr double kMaxCells = 1e15;  // above, a double no longer counts by ones
  return {leaf, {0, 1, 2}, kMaxCells};
}

std::vector<GridEntry> sorted(const Points& points, const Eigen::Vector3d& leaf) {
  return scan_cell_common::sort_into_grid(
      points.size(), [&points](std::size_t i) { return points[i]; }, grid_of(leaf));
}

std::vector<std::size_t> one_of_each_cell(const Points& points, double leaf) {
  std::vector<std::size_t> chosen;
  for_each_cell(sorted(points, Eigen::Vector3d::Constant(leaf)),
                [&chosen](auto begin, auto) { chosen.push_back(begin->point); });
  return chosen;
}

}  // namespace

Points reduce_on_grid(const Points& points, const Eigen::Vector3d& leaf) {
  if (!(leaf.minCoeff() > 0)) {
    throw scan_cell_common::InvalidParameter("leaf", fmt::format("{} m", leaf.minCoeff()),
                                             "give more than 0");
  }
  Points reduced;
  const auto entries = with_even_cells(
      sorted(points, leaf), [&points](std::size_t i) { return points[i]; }, grid_of(leaf));
  for_each_cell(entries, [&](auto begin, auto end) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (auto each = begin; each != end; ++each)
      sum += points[each->point];
    reduced.push_back(sum / static_cast<double>(end - begin));
  });
  return reduced;
}

std::vector<std::size_t> spread_evenly(const Points& points, std::size_t most) {
  std::vector<std::size_t> all(points.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  if (points.size() <= most) return all;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(point);
  // The number of cells on a surface grows with the inverse square of their edge.
  double leaf = box.diagonal().norm() / std::sqrt(static_cast<double>(most));
  constexpr int kTries = 20;       // chosen
  constexpr double kEnough = 0.8;  // of `most`; chosen
  constexpr double kAim = 0.9;     // of `most`; chosen
  std::vector<std::size_t> best;
  for (int i = 0; i < kTries; ++i) {
    std::vector<std::size_t> chosen = one_of_each_cell(points, leaf);
    const double share = static_cast<double>(chosen.size()) / static_cast<double>(most);
    if (share <= 1 && chosen.size() > best.size()) best = std::move(chosen);
    if (share <= 1 && share >= kEnough) break;
    leaf *= std::sqrt(share / kAim);
  }
  return best;
}

Points select(const Points& points, const std::vector<std::size_t>& indices) {
  Points selected;
  selected.reserve(indices.size());
  for (const std::size_t index : indices)
    selected.push_back(points[index]);
  return selected;
}

Points turned(const Points& points, const Eigen::Matrix3d& rotation) {
  Points result;
  for (const Eigen::Vector3d& point : points)
    result.push_back(rotation * point);
  return result;
}

PrincipalFrame principal_frame(const Points& points) {
  PrincipalFrame frame;
  frame.centroid.setZero();
  for (const Eigen::Vector3d& point : points)
    frame.centroid += point;
  frame.centroid /= static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    covariance += (point - frame.centroid) * (point - frame.centroid).transpose();
  }
  covariance /= static_cast<double>(points.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  frame.axes = solver.eigenvectors().rowwise().reverse();
  frame.deviation = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
  if (frame.axes.determinant() < 0) frame.axes.col(2) *= -1;
  return frame;
}

}  // namespace tool_path_stretcher
