// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_registration.h>

#include <cstdlib>
#include <memory>
#include <optional>

#include "geometry/kd_tree.h"
#include "thesis/pcl_clouds.h"
#include "thesis/registrations.h"

namespace tool_path_stretcher {
namespace {

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

Consensus register_by_consensus(const Points& reference, const Points& object,
                                const TriedScales& scales, double inlier_distance,
                                const std::function<void(double)>& progress) {
  const Eigen::Vector3d centre = principal_frame(reference).centroid;
  const Eigen::Vector3d object_centre = principal_frame(object).centroid;
  const Points target = relative_to(reference, centre, 1);
  const KdTree tree(target);
  Consensus best;
  for (int i = -scales.steps; i <= scales.steps; ++i) {
    const double scale = scales.scale * (1 + scales.range * i / scales.steps);
    // The threshold shrinks with the object; otherwise the smallest would have the most inliers.
    const auto sample =
        consensus(target, tree, relative_to(object, object_centre, scale), inlier_distance / scale);
    progress(static_cast<double>(i + scales.steps + 1) / (2 * scales.steps + 1));
    if (!sample || sample->inliers <= best.inliers) continue;
    Similarity found = inverse_of(sample->transform, scale);
    found.translation += object_centre - scale * (found.rotation * centre);
    best = {found, sample->inliers, std::abs(i) == scales.steps};
  }
  return best;
}

}  // namespace tool_path_stretcher
