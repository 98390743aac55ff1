// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "yardsticks/pcl_pipeline.h"

#include <pcl/features/fpfh.h>
#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/sample_consensus_prerejective.h>
#include <pcl/registration/transformation_estimation_svd_scale.h>

#include <Eigen/LU>
#include <cmath>

#include "geometry/points.h"

namespace cases {
namespace {

using Normals = pcl::PointCloud<pcl::PointNormal>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

Cloud::Ptr cloud_of(const Points& points, double scale) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3f scaled = (scale * point).cast<float>();
    cloud->push_back({scaled.x(), scaled.y(), scaled.z()});
  }
  return cloud;
}

/// [m] half the diagonal of the bounding box
double extent_of(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
    box.extend(point);
  return box.diagonal().norm() / 2;
}

/// [m] root mean square distance from the centroid, which does not depend on the pose
double size_of(const Points& points) {
  return tool_path_stretcher::principal_frame(points).deviation.norm();
}

struct Described {
  Normals::Ptr points = std::make_shared<Normals>();
  Features::Ptr features = std::make_shared<Features>();
};

Described describe(const Cloud::Ptr& cloud, float leaf) {
  Cloud reduced;
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(leaf, leaf, leaf);
  grid.filter(reduced);
  Described described;
  pcl::copyPointCloud(reduced, *described.points);
  pcl::NormalEstimation<pcl::PointNormal, pcl::PointNormal> normals;
  normals.setRadiusSearch(2 * leaf);
  normals.setInputCloud(described.points);
  normals.compute(*described.points);
  pcl::FPFHEstimation<pcl::PointNormal, pcl::PointNormal, pcl::FPFHSignature33> features;
  features.setRadiusSearch(5 * leaf);
  features.setInputCloud(described.points);
  features.setInputNormals(described.points);
  features.compute(*described.features);
  return described;
}

struct Pose {
  Eigen::Matrix4f transform = Eigen::Matrix4f::Identity();
  bool converged = false;
};

Pose by_features(const Described& source, const Described& target, float leaf) {
  pcl::SampleConsensusPrerejective<pcl::PointNormal, pcl::PointNormal, pcl::FPFHSignature33> search;
  search.setInputSource(source.points);
  search.setSourceFeatures(source.features);
  search.setInputTarget(target.points);
  search.setTargetFeatures(target.features);
  search.setMaximumIterations(20000);  // instead of the tutorial's 50,000, to save time
  search.setNumberOfSamples(3);
  search.setCorrespondenceRandomness(5);
  search.setSimilarityThreshold(0.95F);
  search.setMaxCorrespondenceDistance(2.5F * leaf);
  search.setInlierFraction(0.25F);
  Normals aligned;
  search.align(aligned);
  return {search.getFinalTransformation(), search.hasConverged()};
}

Pose by_icp(const Cloud::Ptr& source, const Cloud::Ptr& target, const Eigen::Matrix4f& start,
            double max_distance) {
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  using Estimation =
      pcl::registration::TransformationEstimationSVDScale<pcl::PointXYZ, pcl::PointXYZ>;
  icp.setTransformationEstimation(std::make_shared<Estimation>());
  icp.setInputSource(source);
  icp.setInputTarget(target);
  icp.setMaxCorrespondenceDistance(max_distance);
  icp.setMaximumIterations(100);
  icp.setTransformationEpsilon(1e-10);
  Cloud aligned;
  icp.align(aligned, start);
  return {icp.getFinalTransformation(), icp.hasConverged()};
}

Similarity similarity_of(const Eigen::Matrix4f& transform) {
  const Eigen::Matrix3d scaled = transform.topLeftCorner<3, 3>().cast<double>();
  const double scale = std::cbrt(scaled.determinant());
  return {scale, scaled / scale, transform.topRightCorner<3, 1>().cast<double>()};
}

}  // namespace

PclResult pcl_pipeline(const Points& reference, const Points& object, const ToolPath& path) {
  constexpr double kLeaves = 30;  // of the part's half diagonal: 5 mm on a part of 300 mm
  const double scale = size_of(object) / size_of(reference);
  const Cloud::Ptr source = cloud_of(reference, scale);
  const Cloud::Ptr target = cloud_of(object, 1);
  const auto leaf = static_cast<float>(scale * extent_of(reference) / kLeaves);
  const Pose coarse = by_features(describe(source, leaf), describe(target, leaf), leaf);
  const Pose fine = by_icp(source, target, coarse.transform, leaf);
  PclResult result{path, coarse.converged && fine.converged, similarity_of(fine.transform)};
  result.similarity.scale *= scale;
  for (auto& segment : result.path.segments) {
    for (auto& waypoint : segment.waypoints) {
      waypoint.pose.translation() = result.similarity * waypoint.pose.translation();
      waypoint.pose.linear() = result.similarity.rotation * waypoint.pose.linear();
    }
  }
  return result;
}

PclResult pcl_icp(const Points& reference, const Points& object, double max_distance) {
  const Pose pose = by_icp(cloud_of(reference, 1), cloud_of(object, 1), Eigen::Matrix4f::Identity(),
                           max_distance);
  return {{}, pose.converged, similarity_of(pose.transform)};
}

}  // namespace cases
