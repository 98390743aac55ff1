// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/cloud_sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>

#include "path_design/surface/smoothed_cloud.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/geometry/point_tree.h"

namespace part_recipes::path_design {
namespace {

using Eigen::Vector3d;
using scan_cell_common::PointTree;

constexpr double kSteepest = 0.15;  // cosine to the viewer: 81 degrees, so that the noise of
                                    // upright walls does not bring them in; chosen

/// The viewer's picture: x and y in it, and the height towards the viewer.
struct Picture {
  explicit Picture(const Vector3d& viewer)
      : towards(viewer), right(viewer.unitOrthogonal()), up(viewer.cross(right)) {}

  Vector3d flat(const Vector3d& point) const { return {point.dot(right), point.dot(up), 0}; }

  Vector3d towards, right, up;
};

/// Whether each point faces the viewer with nothing of the part in front of it.
std::vector<bool> seen(const SmoothedCloud& cloud, const Picture& picture, double spacing) {
  constexpr double kAside = 1.2;  // spacings: half the diagonal of a square of points, and more
  constexpr double kAbove = 1.5;  // spacings from plane to plane; chosen
  std::vector<bool> facing;
  Points flat;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    facing.push_back(cloud.normals[i].dot(picture.towards) > kSteepest);
    flat.push_back(picture.flat(cloud.points[i]));
  }
  const PointTree search(flat);
  std::vector<bool> result = facing;
  std::vector<std::pair<PointTree::Index, double>> found;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (!facing[i]) continue;
    search.within(flat[i].data(), std::pow(kAside * spacing, 2), found);
    result[i] = std::none_of(found.begin(), found.end(), [&](const auto& each) {
      const Vector3d way = cloud.points[each.first] - cloud.points[i];
      // Above both planes: a steep flank beside the point is above it, but slopes down to it.
      return facing[each.first] && way.dot(cloud.normals[i]) > kAbove * spacing &&
             way.dot(cloud.normals[each.first]) > kAbove * spacing;
    });
  }
  return result;
}

/// Delaunay's triangles of points in a plane, counterclockwise, by their numbers.
std::vector<Triangle> delaunay(const Points& flat, double spacing) {
  constexpr double kStep = 1e-4;  // spacings: whole numbers are what the library takes
  using Point = boost::polygon::point_data<int>;
  const double unit = kStep * spacing;
  std::vector<Point> points;
  for (const Vector3d& point : flat)
    points.emplace_back(static_cast<int>(std::lround(point.x() / unit)),
                        static_cast<int>(std::lround(point.y() / unit)));
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  std::vector<Triangle> triangles;
  for (const auto& vertex : diagram.vertices()) {
    std::vector<std::uint32_t> around;
    const auto* const first = vertex.incident_edge();
    const auto* edge = first;
    do {
      around.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != first);
    for (std::size_t i = 2; i < around.size(); ++i)
      triangles.push_back({around[0], around[i - 1], around[i]});
  }
  return triangles;
}

/// Triangles between the visible points.
class Sheet {
 public:
  Sheet(const SmoothedCloud& cloud, const Picture& picture, double spacing) : picture_(picture) {
    const std::vector<bool> is_seen = seen(cloud, picture, spacing);
    for (std::size_t i = 0; i < is_seen.size(); ++i) {
      if (!is_seen[i]) continue;
      points_.push_back(cloud.points[i]);
      normals_.push_back(cloud.normals[i]);
    }
    constexpr std::size_t kFewest = 3;  // points of a triangle
    if (points_.size() < kFewest) return;
    Points flat;
    for (const Vector3d& point : points_)
      flat.push_back(picture_.flat(point) - picture_.flat(points_.front()));
    triangles_ = delaunay(flat, spacing);
    pitch_ = std::max(spacing, pitch());
  }

  PartMesh mesh() const {
    std::vector<Triangle> kept;
    for (const Triangle& triangle : triangles_)
      if (is_surface(triangle)) kept.push_back(triangle);
    PartMesh mesh = mesh_with_normals(points_, normals_, kept);
    mesh.spacing = pitch_;
    return mesh;
  }

 private:
  double longest_edge(const Triangle& triangle) const {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d edge = points_[triangle[(i + 1) % 3]] - points_[triangle[i]];
      longest = std::max(longest, edge.norm());
    }
    return longest;
  }

  /// [m] between neighbours in the direction in which they are farther apart: a line scanner's
  /// profiles are far apart, the points in them close.
  double pitch() const {
    constexpr double kRandom = 1.5;  // longest edge over spacing, of points at random; measured
    std::vector<double> edges;
    for (const Triangle& triangle : triangles_)
      edges.push_back(longest_edge(triangle));
    if (edges.empty()) return 0;
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::nth_element(edges.begin(), middle, edges.end());
    return *middle / kRandom;
  }

  bool is_surface(const Triangle& triangle) const {
    constexpr double kLongest = 3;      // pitches: a hole in the scan is wider; chosen
    constexpr double kFlattest = 1e-6;  // area over squared pitch: of points on one line
    if (longest_edge(triangle) > kLongest * pitch_) return false;
    const Vector3d& a = points_[triangle[0]];
    const Vector3d cross = (points_[triangle[1]] - a).cross(points_[triangle[2]] - a);
    return cross.dot(picture_.towards) > kSteepest * cross.norm() &&
           cross.norm() > kFlattest * pitch_ * pitch_;
  }

  const Picture picture_;
  double pitch_ = 0;  // [m]
  Points points_, normals_;
  std::vector<Triangle> triangles_;
};

/// The mesh without patches of a few triangles, which are noise.
PartMesh without_crumbs(const PartMesh& mesh) {
  constexpr std::size_t kFewest = 10;  // triangles; chosen
  const std::vector<std::uint32_t> shells = shells_of(mesh);
  std::vector<std::size_t> sizes(mesh.triangles.size(), 0);
  for (const std::uint32_t shell : shells)
    ++sizes[shell];
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < shells.size(); ++t)
    if (sizes[shells[t]] >= kFewest) kept.push_back(t);
  return part_of(mesh, kept);
}

}  // namespace

PartMesh sheet_of(const tool_path_stretcher::Surface& cloud, const Vector3d& towards,
                  const std::string& name) {
  const SmoothedCloud smooth = smoothed(cloud, towards);
  PartMesh mesh = without_crumbs(Sheet(smooth, Picture(towards), cloud.spacing).mesh());
  if (!mesh.triangles.empty()) return mesh;
  throw scan_cell_common::UnusableInput(name, "none of its surface faces the viewer",
                                        "give the side to work on by --from");
}

}  // namespace part_recipes::path_design
