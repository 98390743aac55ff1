// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "thesis/registrations.h"

#include <pcl/registration/icp.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_registration.h>

#include <cmath>
#include <cstdlib>
#include <optional>

#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

Cloud::Ptr cloud_of(const Points& points) {
  return std::make_shared<Cloud>(to_cloud(points));
}

/// p' = s T^-1 p, where T maps the object, at the reference's size, to the reference.
Similarity inverse_of(const Eigen::Matrix4f& to_reference, double scale) {
  const Eigen::Matrix4d back = to_reference.cast<double>().inverse();
  return {scale, nearest_rotation(back.topLeftCorner<3, 3>()), scale * back.topRightCorner<3, 1>()};
}

Points less(const Points& points, const Eigen::Vector3d& centre, double divisor) {
  Points result;
  result.reserve(points.size());
  for (const Eigen::Vector3d& point : points)
    result.push_back((point - centre) / divisor);
  return result;
}

struct Sample {
  Eigen::Matrix4f transform;  // object, at the reference's size, to the reference
  std::size_t inliers = 0;
};

/// RANSAC, then least squares over its inliers (the thesis' figure 31); none if nothing fits.
std::optional<Sample> consensus(const Points& reference, const KdTree& tree, const Points& object,
                                double threshold) {
  Points nearest;
  nearest.reserve(object.size());
  for (const Eigen::Vector3d& point : object)
    nearest.push_back(reference[tree.nearest(point).index]);
  const auto model =
      std::make_shared<pcl::SampleConsensusModelRegistration<pcl::PointXYZ>>(cloud_of(object));
  model->setInputTarget(cloud_of(nearest));
  pcl::RandomSampleConsensus<pcl::PointXYZ> ransac(model, threshold);
  if (!ransac.computeModel()) return std::nullopt;
  pcl::Indices inliers;
  ransac.getInliers(inliers);
  Eigen::VectorXf drawn, fitted;
  ransac.getModelCoefficients(drawn);
  model->optimizeModelCoefficients(inliers, drawn, fitted);
  const Eigen::Map<const Eigen::Matrix<float, 4, 4, Eigen::RowMajor>> rows(fitted.data());
  return Sample{rows, inliers.size()};
}

}  // namespace

double ratio_of_principal_axes(const Points& reference, const Points& object) {
  return principal_frame(object).deviation[0] / principal_frame(reference).deviation[0];
}

Consensus register_by_consensus(const Points& reference, const Points& object,
                                const TriedScales& scales, double inlier_distance,
                                const std::function<void(double)>& progress) {
  const Eigen::Vector3d centre = principal_frame(reference).centroid;
  const Eigen::Vector3d object_centre = principal_frame(object).centroid;
  const Points target = less(reference, centre, 1);
  const KdTree tree(target);
  Consensus best;
  for (int i = -scales.steps; i <= scales.steps; ++i) {
    const double scale = scales.scale * (1 + scales.range * i / scales.steps);
    // The threshold shrinks with the object; otherwise the smallest would have the most inliers.
    const auto sample =
        consensus(target, tree, less(object, object_centre, scale), inlier_distance / scale);
    progress(static_cast<double>(i + scales.steps + 1) / (2 * scales.steps + 1));
    if (!sample || sample->inliers <= best.inliers) continue;
    Similarity found = inverse_of(sample->transform, scale);
    found.translation += object_centre - scale * (found.rotation * centre);
    best = {found, sample->inliers, std::abs(i) == scales.steps};
  }
  return best;
}

Similarity register_by_icp(const Points& reference, const Points& object, double scale) {
  constexpr int kIterations = 100;  // at most; chosen
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputSource(cloud_of(less(object, Eigen::Vector3d::Zero(), scale)));
  icp.setInputTarget(cloud_of(reference));
  icp.setMaximumIterations(kIterations);
  Cloud aligned;
  icp.align(aligned);
  return inverse_of(icp.getFinalTransformation(), scale);
}

Points nearest_points(const Points& at, const Points& object, const Similarity& registration) {
  const KdTree tree(object);
  Points result;
  result.reserve(at.size());
  for (const Eigen::Vector3d& point : at)
    result.push_back(object[tree.nearest(registration * point).index]);
  return result;
}

}  // namespace tool_path_stretcher
