// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/meshes.h"

#include <fmt/format.h>
#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

constexpr std::size_t kMaxCorners = 1000;

/// Twice the area, above 0 if a, b, c turn left.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// The corners in the plane of the polygon (Newell's normal), in counter-clockwise order.
std::vector<Eigen::Vector2d> flattened(const pcl::Vertices& polygon, const Cloud& vertices) {
  std::vector<Eigen::Vector3d> corners;
  for (const pcl::index_t index : polygon.vertices)
    corners.push_back(vertices[static_cast<std::size_t>(index)].getVector3fMap().cast<double>());
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& next = corners[(i + 1) % corners.size()];
    normal += (corners[i] - corners[0]).cross(next - corners[0]);
  }
  const Eigen::Vector3d along =
      normal.isZero() ? Eigen::Vector3d::UnitX() : normal.unitOrthogonal();
  const Eigen::Vector3d across = normal.normalized().cross(along);
  std::vector<Eigen::Vector2d> flat;
  for (const Eigen::Vector3d& corner : corners)
    flat.emplace_back((corner - corners[0]).dot(along), (corner - corners[0]).dot(across));
  return flat;
}

/// Cuts ears off a polygon (Meisters 1975): triangles that contain no other corner.
class Ears {
 public:
  Ears(const pcl::Vertices& polygon, const Cloud& vertices)
      : polygon_(polygon), flat_(flattened(polygon, vertices)), left_(flat_.size()) {
    for (std::size_t i = 0; i < left_.size(); ++i)
      left_[i] = i;
  }

  void cut(std::vector<pcl::Vertices>& triangles) {
    while (left_.size() > 3) {
      std::size_t at = 0;
      while (at < left_.size() && !is_ear(at))
        ++at;
      if (at == left_.size()) at = 0;  // the polygon crosses itself or has no area
      add(at, triangles);
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
    }
    add(1, triangles);
  }

 private:
  std::size_t around(std::size_t at, std::size_t step) const {
    return left_[(at + step) % left_.size()];
  }
  std::size_t before(std::size_t at) const { return around(at, left_.size() - 1); }

  bool is_ear(std::size_t at) const {
    const Eigen::Vector2d& a = flat_[before(at)];
    const Eigen::Vector2d& b = flat_[left_[at]];
    const Eigen::Vector2d& c = flat_[around(at, 1)];
    if (!(turn(a, b, c) > 0)) return false;
    for (const std::size_t other : left_) {
      const Eigen::Vector2d& p = flat_[other];
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  void add(std::size_t at, std::vector<pcl::Vertices>& triangles) const {
    triangles.emplace_back();
    for (const std::size_t corner : {before(at), left_[at], around(at, 1)})
      triangles.back().vertices.push_back(polygon_.vertices[corner]);
  }

  const pcl::Vertices& polygon_;
  std::vector<Eigen::Vector2d> flat_;
  std::vector<std::size_t> left_;
};

}  // namespace

pcl::PolygonMesh mesh_of(Cloud& vertices, std::vector<pcl::Vertices> polygons) {
  vertices.width = static_cast<std::uint32_t>(vertices.points.size());
  vertices.height = 1;
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(vertices, mesh.cloud);
  mesh.polygons = std::move(polygons);
  return mesh;
}

void check_corners(const std::vector<pcl::Vertices>& polygons, std::size_t vertices,
                   const std::string& source, int first) {
  for (const pcl::Vertices& polygon : polygons) {
    for (const pcl::index_t corner : polygon.vertices) {
      if (static_cast<std::size_t>(corner) < vertices) continue;
      throw FileError(
          source,
          fmt::format("a face with vertex {} of {}", std::int64_t{corner} + first, vertices),
          "export the part again");
    }
  }
}

pcl::PolygonMesh triangulated(const pcl::PolygonMesh& mesh, const std::string& source) {
  Cloud vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  pcl::PolygonMesh result;
  result.cloud = mesh.cloud;
  for (const pcl::Vertices& polygon : mesh.polygons) {
    const std::size_t corners = polygon.vertices.size();
    if (corners == 3) {
      result.polygons.push_back(polygon);
      continue;
    }
    if (corners > kMaxCorners) {
      throw FileError(source, fmt::format("a face with {} corners", corners),
                      "export the part as triangles");
    }
    Ears(polygon, vertices).cut(result.polygons);
  }
  return result;
}

}  // namespace scan_cell_common
