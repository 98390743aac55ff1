// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "floor_plane.h"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <iterator>
#include <random>

#include "kd_tree.h"

namespace cloud_preprocess {
namespace {

constexpr std::size_t kSamplePoints = 20000;  // keeps the search well below a second
constexpr std::size_t kLeastPoints = 50;

/// A random choice of points, the same for the same cloud.
Cloud sample(const Cloud& cloud) {
  Cloud chosen;
  std::mt19937 generator(1);
  std::sample(cloud.begin(), cloud.end(), std::back_inserter(chosen), kSamplePoints, generator);
  return chosen;
}

/// Least-squares plane; the normal has a positive z.
template <class Points>
Plane fit_plane(const Points& points) {
  Plane plane;
  plane.point = points.rowwise().mean();
  const Eigen::Matrix3Xd centred = points.colwise() - plane.point;
  const Eigen::Matrix3d covariance = centred * centred.transpose();
  plane.normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  if (plane.normal.z() < 0) plane.normal = -plane.normal;
  return plane;
}

template <class Indices>
Eigen::Matrix3Xd columns(const Cloud& cloud, const Indices& indices) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(indices.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    points.col(i) = cloud[static_cast<std::size_t>(indices[static_cast<std::size_t>(i)])]
                        .getVector3fMap()
                        .cast<double>();
  }
  return points;
}

/// Points around which the surface is level: without them the walls of a box would look like a
/// stack of thin floors.
Cloud level_points(const Cloud& cloud, double tilt) {
  constexpr std::size_t kNeighbours = 10;
  constexpr double kNoise = 0.25;  // [rad] of a normal from so few points
  const double least_z = std::cos(tilt + kNoise);
  const KdTree tree(cloud);
  std::vector<KdTree::Index> indices(std::min(kNeighbours, cloud.size()));
  std::vector<float> squared(indices.size());
  Cloud level;
  for (const pcl::PointXYZ& point : cloud) {
    tree.nearest(point, indices, squared);
    if (fit_plane(columns(cloud, indices)).normal.z() >= least_z) level.push_back(point);
  }
  return level;
}

struct FoundPlane {
  Plane plane;
  Cloud points;
};

std::optional<FoundPlane> largest_level_plane(const Cloud& cloud,
                                              const FloorParameters& parameters) {
  using Model = pcl::SampleConsensusModelPerpendicularPlane<pcl::PointXYZ>;
  const Model::Ptr model(new Model(cloud.makeShared()));  // seeds itself with a constant
  model->setAxis(Eigen::Vector3f::UnitZ());
  model->setEpsAngle(parameters.tilt);
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, parameters.distance);
  ransac.setProbability(0.9999);
  ransac.setMaxIterations(2000);
  if (!ransac.computeModel()) return std::nullopt;
  pcl::Indices inliers;
  ransac.getInliers(inliers);
  return FoundPlane{fit_plane(columns(cloud, inliers)), Cloud(cloud, inliers)};
}

/// Where the points begin and end along an axis, without the outermost few.
std::array<float, 2> extent(const Cloud& cloud, std::size_t axis) {
  constexpr double kOutermost = 0.005;
  std::vector<float> values;
  for (const pcl::PointXYZ& point : cloud)
    values.push_back(point.data[axis]);
  std::sort(values.begin(), values.end());
  const auto skip = static_cast<std::size_t>(kOutermost * static_cast<double>(values.size()));
  return {values[skip], values[values.size() - 1 - skip]};
}

/// A flat inside a frame does not come near the edge of what was scanned on any side.
bool reaches_edge(const Cloud& part, const Cloud& whole) {
  constexpr float kNear = 0.02F;  // of the whole's extent
  for (const std::size_t axis : {0U, 1U}) {
    const auto [part_least, part_most] = extent(part, axis);
    const auto [least, most] = extent(whole, axis);
    const float near = kNear * (most - least);
    if (part_least <= least + near || part_most >= most - near) return true;
  }
  return false;
}

Cloud points_below(const Cloud& cloud, const Plane& plane, double distance) {
  Cloud below;
  std::copy_if(cloud.begin(), cloud.end(), std::back_inserter(below),
               [&](const pcl::PointXYZ& point) { return plane.height(point) < -distance; });
  return below;
}

}  // namespace

std::optional<Plane> find_floor(const Cloud& cloud, const FloorParameters& parameters) {
  const Cloud sampled = sample(cloud);
  const auto share_of = [&sampled](double share) {
    return static_cast<std::size_t>(share * static_cast<double>(sampled.size()));
  };
  const std::size_t least_points = std::max(kLeastPoints, share_of(parameters.least_share));
  Cloud candidates = level_points(sampled, parameters.tilt);
  while (candidates.size() >= least_points) {
    const auto found = largest_level_plane(candidates, parameters);
    if (!found || found->points.size() < least_points) break;
    const double distance = parameters.distance;
    const std::size_t below = points_below(sampled, found->plane, distance).size();
    if (below <= share_of(parameters.most_below)) {
      if (!reaches_edge(found->points, sampled)) break;
      return found->plane;
    }
    candidates = points_below(candidates, found->plane, distance);
  }
  return std::nullopt;
}

}  // namespace cloud_preprocess
