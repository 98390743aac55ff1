// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/surface.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "cores/by_index.h"
#include "geometry/kd_tree.h"
#include "geometry/points.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/errors/errors.h"
#include "surface/complete_surface.h"
#include "surface/edges.h"
#include "tool_path_stretcher/seen_from.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::UnusableInput;

constexpr std::size_t kNormalNeighbours = 12;  // chosen
constexpr std::size_t kRimNeighbours = 20;     // chosen

void check_finite(const Points& points, const std::string& name) {
  const auto bad = std::count_if(points.begin(), points.end(),
                                 [](const Eigen::Vector3d& point) { return !point.allFinite(); });
  if (bad > 0) {
    throw UnusableInput(
        name, fmt::format("{} of {} points are not finite (NaN or infinite)", bad, points.size()),
        "remove them, for instance with rosrun cloud_preprocess clean_cloud");
  }
}

void check_extent(const Points& points, const std::string& name) {
  const Eigen::Vector3d deviation = principal_frame(points).deviation;
  constexpr double kLine = 1e-4;  // width over length; chosen
  if (deviation[1] > kLine * deviation[0]) return;
  throw UnusableInput(name, "all its points lie on one line or in one place",
                      "give a scan that covers the surface of the part");
}

/// Normal of the plane through the nearest neighbours (total least squares).
Eigen::Vector3d normal_of(const Points& points, std::vector<KdTree::Neighbour> neighbours) {
  neighbours.resize(std::min(neighbours.size(), kNormalNeighbours));
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

/// Unit vector tangential to the surface, away from the neighbours; zero if they lie all around the
/// point. A smooth surface ends where the directions to the neighbours leave a wide gap.
Eigen::Vector3d outward_at(const Points& points, const Eigen::Vector3d& at,
                           const Eigen::Vector3d& normal,
                           const std::vector<KdTree::Neighbour>& neighbours) {
  constexpr double kGap = 2.4;  // [rad] 20 random neighbours leave it in 0.2 % of cases
  const Eigen::Vector3d tangent = normal.unitOrthogonal();
  const Eigen::Vector3d bitangent = normal.cross(tangent);
  std::vector<double> angles;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& neighbour : neighbours) {
    const Eigen::Vector3d way = points[neighbour.index] - at;
    const Eigen::Vector2d flat(way.dot(tangent), way.dot(bitangent));
    if (flat.squaredNorm() == 0) continue;
    angles.push_back(std::atan2(flat.y(), flat.x()));
    sum += flat.x() * tangent + flat.y() * bitangent;
  }
  if (angles.empty()) return Eigen::Vector3d::Zero();
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * M_PI - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i)
    gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap > kGap ? Eigen::Vector3d(-sum.normalized()) : Eigen::Vector3d::Zero();
}

/// Whether all neighbours lie in the plane of the surface. Beside a sharp edge, some lie below it.
bool is_flat_at(const Points& points, const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                const std::vector<KdTree::Neighbour>& neighbours) {
  constexpr double kSteepest = 0.5;  // sine: 30 degrees; chosen
  return std::all_of(neighbours.begin(), neighbours.end(), [&](const auto& neighbour) {
    const Eigen::Vector3d way = points[neighbour.index] - at;
    return std::abs(way.dot(normal)) <= kSteepest * std::sqrt(neighbours.back().squared_distance);
  });
}

/// [m] greatest distance of the nearest neighbours from the surface's plane at a point
double blur_at(const Points& points, const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
               const std::vector<KdTree::Neighbour>& neighbours) {
  constexpr std::size_t kNearest = 9;  // eight around it, and the point itself; chosen
  double most = 0;
  for (std::size_t i = 0; i < std::min(kNearest, neighbours.size()); ++i)
    most = std::max(most, std::abs(normal.dot(points[neighbours[i].index] - at)));
  return most;
}

/// Properties of the surface at a point, from its neighbours.
struct Surrounded {
  double spacing;           // [m]
  Eigen::Vector3d normal;   // unit length
  double blur;              // [m]
  Eigen::Vector3d outward;  // unit length; zero if the surface continues all around
  bool flat;                // all neighbours lie in the surface's plane
};

Surrounded surrounded(const Surface& surface, std::size_t i, bool needs_normal) {
  const Eigen::Vector3d& point = surface.points[i];
  std::vector<KdTree::Neighbour> neighbours;
  surface.tree->nearest(point, kRimNeighbours, neighbours);
  Surrounded result;
  // The area filled by the neighbours, divided among them.
  result.spacing =
      std::sqrt(M_PI * neighbours.back().squared_distance / static_cast<double>(neighbours.size()));
  result.normal = needs_normal ? normal_of(surface.points, neighbours) : surface.normals[i];
  result.blur = blur_at(surface.points, point, result.normal, neighbours);
  result.outward = outward_at(surface.points, point, result.normal, neighbours);
  result.flat =
      !result.outward.isZero() && is_flat_at(surface.points, point, result.normal, neighbours);
  return result;
}

/// The patch number of each point. A patch is two spacings wide and lies on one face.
std::vector<std::size_t> patches_of(const Surface& surface) {
  constexpr double kWide = 2;  // spacings; chosen
  std::map<std::array<long, 4>, std::size_t> numbers;
  std::vector<std::size_t> patches;
  for (const std::size_t i : surface.samples.most) {
    const Eigen::Array3d cell = (surface.points[i] / (kWide * surface.spacing)).array().floor();
    Eigen::Index axis = 0;
    surface.normals[i].cwiseAbs().maxCoeff(&axis);
    const std::array<long, 4> at = {std::lround(cell.x()), std::lround(cell.y()),
                                    std::lround(cell.z()), static_cast<long>(axis)};
    patches.push_back(numbers.emplace(at, numbers.size()).first->second);
  }
  return patches;
}

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Leaves out loose points: a few of them, spread over space, would fill half of a sample.
Samples samples_of(const Points& points, const std::vector<double>& spacings, double typical) {
  constexpr double kLoose = 3;  // times the typical spacing; chosen
  std::vector<std::size_t> dense;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (spacings[i] < kLoose * typical) dense.push_back(i);
  }
  const auto sample = [&points](const std::vector<std::size_t>& from, std::size_t most) {
    std::vector<std::size_t> chosen = spread_evenly(select(points, from), most);
    for (std::size_t& index : chosen)
      index = from[index];
    return chosen;
  };
  Samples samples;
  samples.most = sample(dense, 20000);
  samples.many = sample(samples.most, 6000);
  samples.some = sample(samples.many, 3000);
  samples.few = sample(samples.some, 1000);
  samples.fewest = sample(samples.few, 300);
  return samples;
}

}  // namespace

const std::vector<std::size_t>& Samples::of(Density density) const {
  switch (density) {
    case Density::kFewest:
      return fewest;
    case Density::kFew:
      return few;
    case Density::kSome:
      return some;
    case Density::kMany:
      break;
  }
  return many;
}

void complete(Surface& surface) {
  const bool needs_normals = surface.normals.empty();
  surface.tree = std::make_shared<const KdTree>(surface.points);
  const PrincipalFrame frame = principal_frame(surface.points);
  surface.centroid = frame.centroid;
  surface.size = frame.deviation.norm();
  const std::vector<Surrounded> all =
      by_index<Surrounded>(surface.points.size(), kHundreds,
                           [&](std::size_t i) { return surrounded(surface, i, needs_normals); });
  std::vector<double> spacings;
  for (std::size_t i = 0; i < all.size(); ++i) {
    spacings.push_back(all[i].spacing);
    if (needs_normals) surface.normals.push_back(all[i].normal);
    surface.blur.push_back(all[i].blur);
    if (all[i].outward.isZero()) continue;
    surface.rim.points.push_back(surface.points[i]);
    surface.rim.outward.push_back(all[i].outward);
    surface.rim.open.push_back(all[i].flat);
    surface.rim.horizon.push_back(false);
  }
  surface.spacing = middle_of(spacings);
  if (!surface.rim.points.empty()) {
    surface.rim.tree = std::make_shared<const KdTree>(surface.rim.points);
  }
  surface.edges = edges_of(surface);
  for (double& blur : surface.blur)
    blur = std::min(blur, surface.spacing / 2);
  surface.samples = samples_of(surface.points, spacings, surface.spacing);
  surface.samples.patch = patches_of(surface);
}

namespace {

/// Reduces on the grid, or on a coarser one if that leaves more points than are useful: points
/// denser than their noise blur the normals and tell nothing new.
Points reduced(const Points& cloud, Eigen::Vector3d leaf, const std::string& name) {
  constexpr double kMost = 50000;  // points; chosen
  constexpr double kAim = 0.9;     // of those; chosen
  try {
    Points points = reduce_on_grid(cloud, leaf);
    while (static_cast<double>(points.size()) > kMost) {
      leaf *= std::sqrt(static_cast<double>(points.size()) / (kAim * kMost));
      points = reduce_on_grid(cloud, leaf);
    }
    return points;
  } catch (const UnusableInput& error) {  // does not know the cloud's name
    throw UnusableInput(name + ", " + error.thing(), error.value(), error.cure());
  }
}

/// A few points far away would distort the size and axes of the whole.
void check_together(const Points& points, const std::string& name) {
  constexpr double kFar = 1000;  // times the median distance from the middle; chosen
  Eigen::Vector3d middle;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Eigen::Vector3d& point : points)
      values.push_back(point[axis]);
    middle[axis] = middle_of(std::move(values));
  }
  std::vector<double> distances;
  for (const Eigen::Vector3d& point : points)
    distances.push_back((point - middle).norm());
  const double far = kFar * middle_of(distances);
  const auto count = std::count_if(distances.begin(), distances.end(),
                                   [far](double distance) { return distance > far; });
  if (count == 0) return;
  throw UnusableInput(
      name,
      fmt::format("{} of {} points lie far away from all others, up to {:.7g} m", count,
                  points.size(), *std::max_element(distances.begin(), distances.end())),
      "remove them, for instance with rosrun cloud_preprocess clean_cloud");
}

}  // namespace

Surface surface_from_cloud(const Points& cloud, const Eigen::Vector3d& leaf,
                           const std::string& name, const Points& seen_from) {
  if (cloud.empty()) throw UnusableInput(name, "no points", "scan the part again");
  check_finite(cloud, name);
  Surface surface;
  surface.points = reduced(cloud, leaf, name);
  surface.seen_from = seen_from;
  check_together(surface.points, name);
  check_extent(surface.points, name);
  complete(surface);
  return surface;
}

Surface load_surface(const std::string& path, const Eigen::Vector3d& leaf, double metres_per_unit) {
  if (scan_cell_common::is_mesh_file(path)) {
    return surface_from_mesh(scan_cell_common::load_mesh(path, metres_per_unit), leaf, path);
  }
  scan_cell_common::CloudFormat format;
  format.metres_per_unit = metres_per_unit;
  scan_cell_common::FieldedCloud carried;
  const auto loaded = scan_cell_common::load_cloud_file(path, format, carried);
  return surface_from_cloud(to_points(loaded.cloud), leaf, path,
                            directions_seen_from(carried.view()));
}

Points to_points(const pcl::PointCloud<pcl::PointXYZ>& cloud) {
  Points points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& point : cloud)
    points.push_back(point.getVector3fMap().cast<double>());
  return points;
}

pcl::PointCloud<pcl::PointXYZ> to_cloud(const Points& points) {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3f at = point.cast<float>();
    cloud.push_back({at.x(), at.y(), at.z()});
  }
  return cloud;
}

}  // namespace tool_path_stretcher
