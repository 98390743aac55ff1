// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "scan_cell_common/errors.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::UnusableInput;

struct CellEntry {
  std::array<std::int64_t, 3> cell;
  std::size_t point;

  bool operator<(const CellEntry& other) const {
    return cell != other.cell ? cell < other.cell : point < other.point;
  }
};

std::vector<CellEntry> sort_into_cells(const Points& points, const Eigen::Vector3d& leaf) {
  constexpr double kFarthestCell = 1e15;  // beyond it a double no longer counts by ones
  std::vector<CellEntry> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::floor(points[i][axis] / leaf[axis]);
      if (!(std::abs(cell) < kFarthestCell)) {
        std::ostringstream value;
        value << points[i][axis] << " m";
        throw UnusableInput("point " + std::to_string(i), value.str(),
                            "remove points that are not finite or far away from the part");
      }
      entries[i].cell[axis] = static_cast<std::int64_t>(cell);
    }
    entries[i].point = i;
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

std::vector<std::size_t> one_of_each_cell(const Points& points, double leaf) {
  const std::vector<CellEntry> entries = sort_into_cells(points, Eigen::Vector3d::Constant(leaf));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (i == 0 || entries[i].cell != entries[i - 1].cell) chosen.push_back(entries[i].point);
  }
  return chosen;
}

}  // namespace

Points reduce_on_grid(const Points& points, const Eigen::Vector3d& leaf) {
  if (!(leaf.minCoeff() > 0)) {
    throw InvalidParameter("leaf", std::to_string(leaf.minCoeff()) + " m", "give more than 0");
  }
  const std::vector<CellEntry> entries = sort_into_cells(points, leaf);
  Points reduced;
  std::size_t begin = 0;
  while (begin < entries.size()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::size_t end = begin;
    for (; end < entries.size() && entries[end].cell == entries[begin].cell; ++end) {
      sum += points[entries[end].point];
    }
    reduced.push_back(sum / static_cast<double>(end - begin));
    begin = end;
  }
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
  // A surface fills cells by the inverse square of their edge.
  double leaf = box.diagonal().norm() / std::sqrt(static_cast<double>(most));
  constexpr int kTries = 20;
  constexpr double kEnough = 0.8;
  std::vector<std::size_t> best;
  for (int i = 0; i < kTries; ++i) {
    std::vector<std::size_t> chosen = one_of_each_cell(points, leaf);
    const double share = static_cast<double>(chosen.size()) / static_cast<double>(most);
    if (share <= 1 && chosen.size() > best.size()) best = std::move(chosen);
    if (share <= 1 && share >= kEnough) break;
    constexpr double kAim = 0.9;
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
