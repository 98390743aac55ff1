// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/surface.h"

#include <pcl/conversions.h>

#include <Eigen/Geometry>
#include <utility>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/geometry/nearest_in_scene.h"
#include "scan_cell_common/geometry/nearest_on_triangle.h"
#include "scan_cell_common/geometry/triangle_scene.h"
#include "tool_path_stretcher/surface.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;

SurfaceShape shape_of(const pcl::PolygonMesh& mesh) {
  SurfaceShape shape;
  scan_cell_common::Cloud corners;
  pcl::fromPCLPointCloud2(mesh.cloud, corners);
  shape.points = tool_path_stretcher::to_points(corners);
  for (const pcl::Vertices& face : mesh.polygons) {
    const auto corner = [&face](std::size_t i) {
      return static_cast<std::uint32_t>(face.vertices.at(i));
    };
    shape.triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return shape;
}

}  // namespace

SurfaceShape squares_on(const std::vector<Vector3d>& points, const std::vector<Vector3d>& normals,
                        double spacing) {
  constexpr double kHalfSide = 0.75;  // spacings: those of a square grid cover it from 0.71 on
  constexpr double kClearance = 2.5;  // spacings: beyond the squares that overlap; chosen
  SurfaceShape shape;
  shape.clearance = kClearance * spacing;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d along = kHalfSide * spacing * normals[i].unitOrthogonal();
    const Vector3d across = normals[i].cross(along);
    const auto corner = static_cast<std::uint32_t>(shape.points.size());
    for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      shape.points.emplace_back(points[i] + a * along + b * across);
    shape.triangles.push_back({corner, corner + 1, corner + 2});
    shape.triangles.push_back({corner, corner + 2, corner + 3});
  }
  return shape;
}

SurfaceShape load_shape(const std::string& path, const Vector3d& leaf, double metres_per_unit) {
  if (scan_cell_common::is_mesh_file(path))
    return shape_of(scan_cell_common::load_mesh(path, metres_per_unit));
  const auto cloud = tool_path_stretcher::load_surface(path, leaf, metres_per_unit);
  return squares_on(cloud.points, cloud.normals, cloud.spacing);
}

SurfaceShape placed(const SurfaceShape& shape, const tool_path_stretcher::Similarity& similarity) {
  SurfaceShape result = shape;
  for (Vector3d& point : result.points)
    point = similarity * point;
  result.clearance *= similarity.scale;
  return result;
}

struct Surface::Implementation {
  explicit Implementation(const SurfaceShape& given)
      : shape(given), triangles(given.points, given.triangles) {}

  /// The nearest place on one triangle, given by its number.
  Place nearest_of(unsigned triangle, const Vector3d& point) const {
    const auto& corner = shape.triangles[triangle];
    const Vector3d &a = shape.points[corner[0]], &b = shape.points[corner[1]],
                   &c = shape.points[corner[2]];
    Place place;
    place.normal = (b - a).cross(c - a).normalized();
    place.point = scan_cell_common::nearest_on_triangle(point, a, b, c);
    place.distance = (place.point - point).norm();
    return place;
  }

  SurfaceShape shape;
  scan_cell_common::TriangleScene triangles;
};

Surface::Surface(const SurfaceShape& shape) {
  if (shape.triangles.empty()) {
    throw scan_cell_common::UnusableInput("surface", "no triangles",
                                          "give a mesh or a cloud of the part");
  }
  implementation_ = std::make_unique<Implementation>(shape);
}

Surface::~Surface() = default;
Surface::Surface(Surface&&) noexcept = default;
Surface& Surface::operator=(Surface&&) noexcept = default;

Surface::Place Surface::nearest(const Vector3d& point) const {
  return scan_cell_common::nearest_in_scene<Place>(
      implementation_->triangles.scene(), point, [&](unsigned /*geometry*/, unsigned triangle) {
        return implementation_->nearest_of(triangle, point);
      });
}

std::optional<Vector3d> Surface::obstacle(const Vector3d& on_surface, const Vector3d& eye) const {
  const Vector3d way = eye - on_surface;
  const double length = way.norm();
  const Vector3d direction = way / length;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  const Eigen::Vector3f from = on_surface.cast<float>(), along = direction.cast<float>();
  ray.ray = {from.x(),
             from.y(),
             from.z(),
             static_cast<float>(implementation_->shape.clearance),
             along.x(),
             along.y(),
             along.z(),
             0,
             static_cast<float>(length),
             0xFFFFFFFFU,
             0,
             0};
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(implementation_->triangles.scene(), &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return on_surface + static_cast<double>(ray.ray.tfar) * direction;
}

}  // namespace pass_planner
