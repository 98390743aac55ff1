// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/pca.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/registration/icp.h>

#include <chrono>
#include <cstdio>

#include "synthetic_parts.h"
#include "tool_path_stretcher/stretcher.h"

namespace {

using namespace tool_path_stretcher;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Outcome {
  double seconds = 0;
  double rms = 0;  // [m] path against truth; NaN where refused
};

Cloud::Ptr cloud_of(const Points& points, double scale) {
  auto cloud = std::make_shared<Cloud>();
  for (const Eigen::Vector3d& point : points) {
    cloud->push_back({static_cast<float>(scale * point.x()), static_cast<float>(scale * point.y()),
                      static_cast<float>(scale * point.z())});
  }
  return cloud;
}

/// The thesis' general method (9.7) written plainly with PCL: scale from PCA, ICP, nearest point,
/// way back. As written it starts from where the clouds lie.
ToolPath thesis_method(const Points& reference, const Points& object, const ToolPath& path) {
  const auto largest_deviation = [](const Cloud::Ptr& cloud) {
    pcl::PCA<pcl::PointXYZ> pca;
    pca.setInputCloud(cloud);
    return std::sqrt(pca.getEigenValues()[0]);
  };
  const Cloud::Ptr target = cloud_of(reference, 1);
  const double scale = largest_deviation(cloud_of(object, 1)) / largest_deviation(target);
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setInputSource(cloud_of(object, 1 / scale));
  icp.setInputTarget(target);
  icp.setMaximumIterations(100);
  const auto aligned = std::make_shared<Cloud>();
  icp.align(*aligned);
  const Eigen::Matrix4d back = icp.getFinalTransformation().cast<double>().inverse();
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(aligned);
  ToolPath result = path;
  for (Segment& segment : result.segments) {
    for (Waypoint& waypoint : segment.waypoints) {
      const Eigen::Vector3d at = waypoint.pose.translation();
      const pcl::PointXYZ query(static_cast<float>(at.x()), static_cast<float>(at.y()),
                                static_cast<float>(at.z()));
      std::vector<int> index(1);
      std::vector<float> squared(1);
      tree.nearestKSearch(query, 1, index, squared);
      const pcl::PointXYZ& found = (*aligned)[static_cast<std::size_t>(index[0])];
      const Eigen::Vector4d nearest(found.x, found.y, found.z, 1);
      waypoint.pose.translation() = scale * (back * nearest).head<3>();
    }
  }
  return result;
}

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void compare(const char* name, const synthetic::Part& part, const Similarity& moved,
             const synthetic::Deformation& deformation) {
  synthetic::Scan how;
  const Points reference = synthetic::scan(part, {}, synthetic::no_deformation(), how);
  how.seed = 2;
  const Points object = synthetic::scan(part, moved, deformation, how);
  const ToolPath path = synthetic::path_on(part, 400);
  const ToolPath truth = synthetic::truth(path, moved, deformation);
  Outcome thesis;
  thesis.seconds = seconds_of(
      [&] { thesis.rms = synthetic::error_of(thesis_method(reference, object, path), truth).rms; });
  Outcome ours;
  const StretchParameters parameters;
  std::string verdict;
  ours.seconds = seconds_of([&] {
    const StretchResult result =
        stretch(surface_from_cloud(reference, parameters.leaf, "r"),
                surface_from_cloud(object, parameters.leaf, "o"), path, parameters);
    verdict = to_string(result.verdict.reason);
    ours.rms =
        result.verdict.accepted() ? synthetic::error_of(result.path, truth).rms : std::nan("");
  });
  std::printf("stretcher time, %s: %.2f s, thesis with PCL %.2f s, ratio %.2f\n", name,
              ours.seconds, thesis.seconds, thesis.seconds / ours.seconds);
  std::printf("stretcher path RMS, %s: %.3f mm (%s), thesis with PCL %.3f mm, ratio %.1f\n", name,
              1e3 * ours.rms, verdict.c_str(), 1e3 * thesis.rms, thesis.rms / ours.rms);
}

}  // namespace

int main() {
  const auto yaw = [](double degrees) {
    return Eigen::AngleAxisd(degrees * M_PI / 180, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  };
  const auto none = synthetic::no_deformation();
  const auto frame = synthetic::photo_frame();
  const auto panel = synthetic::curved_panel();
  const Eigen::Vector3d shift(0.02, -0.01, 0.005);
  compare("frame turned 5 deg, x 1.08", frame, synthetic::similarity(1.08, yaw(5), shift), none);
  compare("frame turned 150 deg, x 1.08", frame, synthetic::similarity(1.08, yaw(150), shift),
          none);
  compare("frame turned 5 deg, x 1.08, bent 4 mm", frame,
          synthetic::similarity(1.08, yaw(5), shift), synthetic::bend(0.004, 0.2));
  compare("panel turned 5 deg, x 0.9", panel, synthetic::similarity(0.9, yaw(5), shift), none);
  compare("panel any turn, x 1.3", panel,
          synthetic::similarity(1.3, synthetic::random_rotation(4), shift), none);
  return 0;
}
