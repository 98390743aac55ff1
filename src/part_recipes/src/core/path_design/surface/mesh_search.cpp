// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path_design/surface/mesh_search.h"

#include <Eigen/Geometry>
#include <limits>

#include "scan_cell_common/geometry/nearest_in_scene.h"
#include "scan_cell_common/geometry/nearest_on_triangle.h"
#include "scan_cell_common/geometry/triangle_scene.h"

namespace part_recipes::path_design {

using Eigen::Vector3d;

struct MeshSearch::Scene {
  explicit Scene(const PartMesh& given) : mesh(given), triangles(given.vertices, given.triangles) {}

  Foot foot_on(std::uint32_t triangle, const Vector3d& point) const {
    const auto& [i, j, k] = mesh.triangles[triangle];
    Foot foot;
    foot.triangle = triangle;
    foot.point = scan_cell_common::nearest_on_triangle(point, mesh.vertices[i], mesh.vertices[j],
                                                       mesh.vertices[k]);
    foot.distance = (foot.point - point).norm();
    return foot;
  }

  /// The normals of the corners, weighted by the areas opposite to them.
  Vector3d normal_at(const Foot& foot) const {
    const Triangle& corners = mesh.triangles[foot.triangle];
    const Vector3d& facet = mesh.facets[foot.triangle];
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d one = mesh.vertices[corners[(i + 1) % 3]] - foot.point;
      const Vector3d other = mesh.vertices[corners[(i + 2) % 3]] - foot.point;
      sum += one.cross(other).dot(facet) * mesh.normals[foot.triangle][i];
    }
    return sum.normalized();
  }

  const PartMesh& mesh;
  scan_cell_common::TriangleScene triangles;
};

MeshSearch::MeshSearch(const PartMesh& mesh) : scene_(std::make_unique<Scene>(mesh)) {}

MeshSearch::~MeshSearch() = default;

const PartMesh& MeshSearch::mesh() const {
  return scene_->mesh;
}

Foot MeshSearch::nearest(const Vector3d& point) const {
  Foot foot = scan_cell_common::nearest_in_scene<Foot>(
      scene_->triangles.scene(), point,
      [&](unsigned /*geometry*/, unsigned triangle) { return scene_->foot_on(triangle, point); });
  foot.normal = scene_->normal_at(foot);
  return foot;
}

bool MeshSearch::is_hidden(const Vector3d& place, const Vector3d& towards) const {
  constexpr float kClearance = 2e-5F;  // [m] from the surface itself, in single precision; chosen
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const Eigen::Vector3f from = place.cast<float>(), along = towards.cast<float>();
  RTCRay ray{};
  ray.org_x = from.x();
  ray.org_y = from.y();
  ray.org_z = from.z();
  ray.dir_x = along.x();
  ray.dir_y = along.y();
  ray.dir_z = along.z();
  ray.tnear = kClearance;
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = 0xFFFFFFFFU;
  rtcOccluded1(scene_->triangles.scene(), &context, &ray);
  return ray.tfar < 0;
}

double length_along(const MeshSearch& surface, const Vector3d& from, const Vector3d& to) {
  constexpr int kSteps = 16;  // an arc of 1 rad comes out 0.01 % short
  double length = 0;
  Vector3d last = from;
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const Vector3d next = i == kSteps ? to : surface.nearest(from + share * (to - from)).point;
    length += (next - last).norm();
    last = next;
  }
  return length;
}

}  // namespace part_recipes::path_design
