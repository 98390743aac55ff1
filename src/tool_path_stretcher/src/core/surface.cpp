// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/surface.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "scan_cell_common/errors.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kNormalNeighbours = 12;

void check_finite(const Points& points, const std::string& name) {
  const auto bad = std::count_if(points.begin(), points.end(),
                                 [](const Eigen::Vector3d& point) { return !point.allFinite(); });
  if (bad > 0) {
    throw UnusableInput(name,
                        std::to_string(bad) + " of " + std::to_string(points.size()) +
                            " points are not finite (NaN or infinite)",
                        "remove them, for instance with cloud_preprocess");
  }
}

void check_extent(const Points& points, const std::string& name) {
  const Eigen::Vector3d deviation = principal_frame(points).deviation;
  constexpr double kLine = 1e-4;
  if (deviation[1] > kLine * deviation[0]) return;
  throw UnusableInput(name, "all its points lie on one line or in one place",
                      "give a scan that covers the surface of the part");
}

/// Normal of the plane through the neighbours (total least squares).
Eigen::Vector3d normal_of(const Points& points, const std::vector<KdTree::Neighbour>& neighbours) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& neighbour : neighbours)
    mean += points[neighbour.index];
  mean /= static_cast<double>(neighbours.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& neighbour : neighbours) {
    const Eigen::Vector3d offset = points[neighbour.index] - mean;
    covariance += offset * offset.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  return solver.eigenvectors().col(0).normalized();
}

double root_mean_square_radius(const Points& points) {
  return principal_frame(points).deviation.norm();
}

/// Normals of all points, and the typical spacing from the area that the neighbours fill.
void add_normals(Surface& surface) {
  std::vector<double> spacings;
  std::vector<KdTree::Neighbour> neighbours;
  surface.normals.reserve(surface.points.size());
  for (const Eigen::Vector3d& point : surface.points) {
    surface.tree->nearest(point, kNormalNeighbours, neighbours);
    surface.normals.push_back(normal_of(surface.points, neighbours));
    spacings.push_back(std::sqrt(M_PI * neighbours.back().squared_distance /
                                 static_cast<double>(neighbours.size())));
  }
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  surface.spacing = *middle;
}

}  // namespace

Surface surface_from_cloud(const Points& cloud, const Eigen::Vector3d& leaf,
                           const std::string& name) {
  if (cloud.empty()) throw UnusableInput(name, "no points", "scan the part again");
  check_finite(cloud, name);
  Surface surface;
  surface.points = reduce_on_grid(cloud, leaf);
  check_extent(surface.points, name);
  surface.tree = std::make_shared<const KdTree>(surface.points);
  surface.size = root_mean_square_radius(surface.points);
  add_normals(surface);
  return surface;
}

Surface load_surface(const std::string& path, const Eigen::Vector3d& leaf) {
  if (scan_cell_common::is_mesh_file(path)) {
    return surface_from_mesh(scan_cell_common::load_mesh(path), leaf, path);
  }
  return surface_from_cloud(to_points(scan_cell_common::load_cloud(path)), leaf, path);
}

Points to_points(const scan_cell_common::Cloud& cloud) {
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.push_back(point.getVector3fMap().cast<double>());
  return points;
}

}  // namespace tool_path_stretcher
