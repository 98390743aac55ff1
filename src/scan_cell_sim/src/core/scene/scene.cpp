// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/scene.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "scan_cell_common/geometry/nearest_in_scene.h"
#include "scan_cell_common/geometry/nearest_on_triangle.h"

namespace scan_cell_sim {
namespace {

using Eigen::Vector3d;

/// Distance from a surface at which rays that leave it begin: in single precision they could hit
/// the surface itself.
constexpr float kClearance = 1e-4F;  // [m] chosen

Mesh floor_mesh(const Floor& floor) {
  const double x = floor.size.x() / 2;
  const double y = floor.size.y() / 2;
  const double z = floor.height;
  return {{{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

RTCRay make_ray(const Vector3d& origin, const Vector3d& direction, float near, float far) {
  const Eigen::Vector3f o = origin.cast<float>();
  const Eigen::Vector3f d = direction.cast<float>();
  RTCRay ray{};
  ray.org_x = o.x();
  ray.org_y = o.y();
  ray.org_z = o.z();
  ray.dir_x = d.x();
  ray.dir_y = d.y();
  ray.dir_z = d.z();
  ray.tnear = near;
  ray.tfar = far;
  ray.mask = 0xFFFFFFFFU;
  return ray;
}

}  // namespace

struct Scene::Implementation {
  Implementation() : device(rtcNewDevice("threads=1")), scene(rtcNewScene(device)) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Implementation() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void add(Mesh mesh, double reflectance) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.vertices.size()));
    auto* const indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if (vertices == nullptr || indices == nullptr) throw std::bad_alloc();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      Eigen::Map<Eigen::Vector3f>(vertices + 3 * i) = mesh.vertices[i].cast<float>();
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      std::copy(mesh.triangles[i].begin(), mesh.triangles[i].end(), indices + 3 * i);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);  // numbers geometries from 0, as `meshes`
    rtcReleaseGeometry(geometry);
    meshes.push_back(std::move(mesh));
    reflectances.push_back(reflectance);
  }

  void commit() { rtcCommitScene(scene); }

  std::array<Vector3d, 3> corners(unsigned geometry, unsigned triangle) const {
    const Mesh& mesh = meshes[geometry];
    const auto& corner = mesh.triangles[triangle];
    return {mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]]};
  }

  RTCDevice device;
  RTCScene scene;
  std::vector<Mesh> meshes;
  std::vector<double> reflectances;
  std::optional<Checkerboard> board;
  unsigned board_surface = 0;
};

Scene::Scene(const World& world) : implementation_(std::make_unique<Implementation>()) {
  if (world.floor) implementation_->add(floor_mesh(*world.floor), world.floor->reflectance);
  if (world.board) {
    implementation_->board = world.board;
    implementation_->board_surface = static_cast<unsigned>(implementation_->meshes.size());
    implementation_->add(world.board->mesh(), world.board->white);
  }
  for (const Part& part : world.parts) {
    implementation_->add(part.mesh(kTolerance), part.reflectance);
  }
  implementation_->commit();
}

Scene::Scene(const World& world, const std::string& part)
    : Scene(World{std::nullopt, std::nullopt, {world.part(part)}}) {}

Scene::Scene(const std::vector<Mesh>& surfaces, double reflectance)
    : implementation_(std::make_unique<Implementation>()) {
  for (const Mesh& surface : surfaces)
    implementation_->add(surface, reflectance);
  implementation_->commit();
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

std::optional<Scene::Hit> Scene::first_hit(const Vector3d& origin,
                                           const Vector3d& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray{};
  ray.ray = make_ray(origin, direction, 0, std::numeric_limits<float>::infinity());
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(implementation_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  // Embree finds the triangle; the point is where the ray meets its plane in double precision.
  const auto [a, b, c] = implementation_->corners(ray.hit.geomID, ray.hit.primID);
  Hit hit;
  hit.normal = (b - a).cross(c - a).normalized();
  const double towards = hit.normal.dot(direction);
  hit.distance = towards != 0 ? hit.normal.dot(a - origin) / towards : ray.ray.tfar;
  if (towards > 0) hit.normal = -hit.normal;
  hit.point = origin + hit.distance * direction;
  hit.surface = ray.hit.geomID;
  hit.reflectance = implementation_->reflectances[hit.surface];
  if (is_on_board(hit)) {
    constexpr double kSharp = 1e-5;  // [m] blur; chosen
    const Vector3d on_board = board()->pose.inverse() * hit.point;
    hit.reflectance = board()->reflectance(on_board.head<2>(), {kSharp, kSharp});
  }
  return hit;
}

const std::optional<Checkerboard>& Scene::board() const {
  return implementation_->board;
}

bool Scene::is_on_board(const Hit& hit) const {
  return board() && hit.surface == implementation_->board_surface;
}

bool Scene::sees(const Vector3d& surface_point, const Vector3d& eye) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const Vector3d way = eye - surface_point;
  const double distance = way.norm();
  RTCRay ray = make_ray(surface_point, way / distance, kClearance, static_cast<float>(distance));
  rtcOccluded1(implementation_->scene, &context, &ray);
  return ray.tfar >= 0;  // Embree sets it to -infinity if something is in the way
}

double Scene::distance_to_surface(const Vector3d& point) const {
  struct Found {
    double distance;
  };
  const auto measure = [&](unsigned geometry, unsigned triangle) -> Found {
    const auto [a, b, c] = implementation_->corners(geometry, triangle);
    return {(point - scan_cell_common::nearest_on_triangle(point, a, b, c)).norm()};
  };
  return scan_cell_common::nearest_in_scene<Found>(implementation_->scene, point, measure).distance;
}

const std::vector<Mesh>& Scene::meshes() const {
  return implementation_->meshes;
}

}  // namespace scan_cell_sim
