// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "draws.h"

#include <pcl/conversions.h>
#include <pcl/point_types.h>

#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>

namespace cases {
namespace {

using Eigen::Vector2d;
using tool_path_stretcher::Reason;
using tool_path_stretcher::Surface;

/// A solid whose outline is symmetric under `turns` rotations about the origin and mirroring at the
/// x axis.
struct Symmetric {
  std::string name;
  Solid solid;
  int turns;
  double radius;  // [m] of the circle around it
};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int one_of(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  bool coin() { return one_of(0, 1) == 1; }

 private:
  std::mt19937 engine_;
};

constexpr int kRound = 72;  // corners of a polygon that stands for a circle

std::vector<Loop> holes_around(int count, double radius, double hole) {
  std::vector<Loop> holes;
  for (const Vector2d& at : regular(count, radius))
    holes.push_back(circle(at, hole, 24));
  return holes;
}

Symmetric prism(int corners, double radius, double height) {
  return {std::to_string(corners) + "-sided prism",
          {regular(corners, radius), {}, height},
          corners,
          radius};
}

Symmetric box(double width, double depth, double height) {
  return {"box", {rectangle_loop(width, depth), {}, height}, 2, std::hypot(width, depth) / 2};
}

Symmetric flange(int bolts, double radius, double height, Random& random) {
  const double bore = random.coin() ? random.between(0.25, 0.4) * radius : 0;
  const double hole = std::min(random.between(0.08, 0.13), 1.8 / bolts) * radius;
  std::vector<Loop> holes = holes_around(bolts, random.between(0.62, 0.75) * radius, hole);
  if (bore > 0) holes.push_back(circle(Vector2d::Zero(), bore, kRound));
  return {"flange of " + std::to_string(bolts) + " holes",
          {circle(Vector2d::Zero(), radius, kRound), holes, height},
          bolts,
          radius};
}

Symmetric plate(double width, double depth, double height, Random& random) {
  const double hole = random.between(0.05, 0.09) * depth;
  std::vector<Loop> holes;
  for (const double x : {-0.4, 0.4}) {
    for (const double y : {-0.35, 0.35})
      holes.push_back(circle({x * width, y * depth}, hole, 24));
  }
  return {"plate of 4 holes",
          {rectangle_loop(width, depth), holes, height},
          2,
          std::hypot(width, depth) / 2};
}

Symmetric known_shape(int which, Random& random) {
  const double radius = random.between(0.04, 0.14);
  const double high = random.between(0.2, 1.5) * radius;
  const double flat = random.between(0.12, 0.3) * radius;
  switch (which % 10) {
    case 0:
      return box(2 * radius, random.between(0.7, 1.7) * radius, high);
    case 1:
      return prism(3, radius, high);
    case 2:
      return prism(4, radius, high);
    case 3:
      return prism(5, radius, high);
    case 4:
      return prism(6, radius, high);
    case 5:
      return flange(random.one_of(3, 6), radius, flat, random);
    case 6:
      return flange(random.one_of(7, 12), radius, flat, random);
    case 7:
      return {"disc", {circle(Vector2d::Zero(), radius, kRound), {}, high}, kRound, radius};
    case 8:
      return {"cross", {cross(2 * radius, random.between(0.4, 0.9) * radius), {}, flat}, 4, radius};
    default:
      return plate(2 * radius, random.between(0.9, 1.6) * radius, flat, random);
  }
}

Symmetric other_shape(int which, Random& random) {
  const double radius = random.between(0.04, 0.14);
  const double high = random.between(0.2, 1.5) * radius;
  const double flat = random.between(0.12, 0.3) * radius;
  const int points = random.one_of(3, 9);
  switch (which % 10) {
    case 0:
      return {"cube", {rectangle_loop(1.4 * radius, 1.4 * radius), {}, 1.4 * radius}, 4, radius};
    case 1:
      return prism(7, radius, high);
    case 2:
      return prism(8, radius, high);
    case 3:
      return {std::to_string(points) + "-pointed star",
              {star(points, radius, random.between(0.6, 0.8) * radius), {}, high},
              points,
              radius};
    case 4:
      return {
          "gear", {star(2 * points + 6, radius, 0.88 * radius), {}, flat}, 2 * points + 6, radius};
    case 5:
      return {"ring",
              {circle(Vector2d::Zero(), radius, kRound),
               {circle(Vector2d::Zero(), random.between(0.4, 0.7) * radius, kRound)},
               flat},
              kRound,
              radius};
    case 6:
      return {"rhombus",
              {{{radius, 0}, {0, 0.6 * radius}, {-radius, 0}, {0, -0.6 * radius}}, {}, high},
              2,
              radius};
    case 7:
      return {"pyramid stump",
              {regular(points, radius), {}, high, random.between(0.5, 0.8)},
              points,
              radius};
    case 8:
      return {
          "cone stump", {circle(Vector2d::Zero(), radius, kRound), {}, high, 0.7}, kRound, radius};
    default:
      return {"slotted square",
              {rectangle_loop(1.4 * radius, 1.4 * radius),
               {rectangle_loop(random.between(0.4, 0.9) * radius, 0.3 * radius)},
               flat},
              2,
              radius};
  }
}

/// Whether a circle lies in the material of the solid.
bool has_room(const Solid& solid, const Vector2d& at, double radius) {
  if (!is_inside(solid.outline, at) || distance_to(solid.outline, at) < radius) return false;
  for (const Loop& hole : solid.holes) {
    if (is_inside(hole, at) || distance_to(hole, at) < radius) return false;
  }
  return true;
}

/// Distance [m] of a point of the plane from its nearest image under the outline's symmetries.
double from_images(const Symmetric& shape, const Vector2d& at) {
  double least = 2 * shape.radius;
  for (int i = 0; i < shape.turns; ++i) {
    for (const double mirror : {1.0, -1.0}) {
      if (i == 0 && mirror > 0) continue;
      const Eigen::Rotation2Dd turn(2 * M_PI * i / shape.turns);
      least = std::min(least, (turn * Vector2d(at.x(), mirror * at.y()) - at).norm());
    }
  }
  return least;
}

/// Bores a hole away from all its images. A round solid has flips that no hole breaks, so it gets a
/// slope instead.
bool bore(Symmetric& shape, double radius, Random& random) {
  const bool round = shape.turns == kRound;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d at = shape.radius * Vector2d(random.between(-1, 1), random.between(-1, 1));
    if (!has_room(shape.solid, at, 1.4 * radius)) continue;
    if (at.norm() < 2 * radius || (!round && from_images(shape, at) < 2.2 * radius)) continue;
    shape.solid.holes.push_back(circle(at, radius, 24));
    if (round) shape.solid.taper = 0.8;
    return true;
  }
  return false;
}

/// A straight path on the top, clear of edges.
std::optional<ToolPath> path_on_top(const Solid& solid, double radius, Random& random) {
  constexpr std::size_t kCount = 60;
  const double clear = 0.06 * radius;
  for (int tries = 0; tries < 20000; ++tries) {
    const Vector2d from = radius * Vector2d(random.between(-1, 1), random.between(-1, 1));
    const Vector2d to = radius * Vector2d(random.between(-1, 1), random.between(-1, 1));
    const Vector2d way = to - from;
    if (way.norm() < 0.3 * radius) continue;
    bool free = true;
    for (std::size_t i = 0; i < kCount && free; ++i)
      free = has_room(solid, from + static_cast<double>(i) / (kCount - 1) * way, clear);
    if (!free) continue;
    ToolPath path;
    path.has_orientation = true;
    path.segments.push_back({"path", {}});
    for (std::size_t i = 0; i < kCount; ++i) {
      tool_path_stretcher::Waypoint waypoint;
      const Vector2d at = solid.taper * (from + static_cast<double>(i) / (kCount - 1) * way);
      waypoint.pose.translation() << at, solid.height;
      waypoint.pose.linear() =
          Eigen::AngleAxisd(std::atan2(way.y(), way.x()), Eigen::Vector3d::UnitZ())
              .toRotationMatrix();
      path.segments[0].waypoints.push_back(waypoint);
    }
    return path;
  }
  return {};
}

/// An angle plate, narrower at its top, with a hole. With equal legs and the hole between them, it
/// has a mirror plane.
Symmetric angle_plate(bool has_mirror, Random& random) {
  const double radius = random.between(0.05, 0.14);
  const double wide = random.between(0.35, 0.6) * radius;
  const double other = has_mirror ? 1 : random.between(0.6, 0.8);
  Symmetric shape;
  shape.name = has_mirror ? "angle plate of equal legs" : "angle plate";
  shape.radius = radius;
  shape.turns = 1;
  shape.solid.outline = {{-wide, -wide}, {radius, -wide},     {radius, 0},
                         {0, 0},         {0, other * radius}, {-wide, other * radius}};
  shape.solid.height = random.between(0.2, 0.5) * radius;
  shape.solid.taper = random.between(0.75, 0.9);
  if (random.coin())
    shape.solid.holes = {circle({-wide / 2, -wide / 2}, random.between(0.2, 0.3) * wide)};
  return shape;
}

pcl::PolygonMesh mirrored(pcl::PolygonMesh mesh) {
  pcl::PointCloud<pcl::PointXYZ> vertices;
  pcl::fromPCLPointCloud2(mesh.cloud, vertices);
  for (pcl::PointXYZ& vertex : vertices)
    vertex.x = -vertex.x;
  pcl::toPCLPointCloud2(vertices, mesh.cloud);
  for (pcl::Vertices& triangle : mesh.polygons)
    std::swap(triangle.vertices[0], triangle.vertices[1]);
  return mesh;
}

Points sampled(const pcl::PolygonMesh& mesh, std::size_t count, double noise,
               const Similarity& moved, unsigned seed) {
  Scan how;
  how.points = count;
  how.noise = noise;
  how.seed = seed;
  return scan(part_of_mesh(mesh, {}), none(), moved, how);
}

Symmetric shape_of(Draw what, Shapes shapes, unsigned seed, Random& random) {
  if (what == Draw::kMirrored || what == Draw::kMirrorSymmetric)
    return angle_plate(what == Draw::kMirrorSymmetric, random);
  const int which = static_cast<int>(seed);
  Symmetric shape =
      shapes == Shapes::kKnown ? known_shape(which, random) : other_shape(which, random);
  if (what == Draw::kDistinguishable &&
      !bore(shape, random.between(0.1, 0.16) * shape.radius, random))
    return shape_of(what, shapes, seed, random);
  return shape;
}

}  // namespace

DrawnPart draw(Draw what, Shapes shapes, double noise, unsigned seed) {
  Random random(seed * 2654435761U + (shapes == Shapes::kKnown ? 0 : 77777));
  for (int tries = 0; tries < 100; ++tries) {
    const Symmetric shape = shape_of(what, shapes, seed, random);
    const auto path = path_on_top(shape.solid, shape.radius, random);
    if (!path) continue;
    DrawnPart part;
    part.name = shape.name;
    part.expected = what == Draw::kSymmetric  ? Reason::kAmbiguous
                    : what == Draw::kMirrored ? Reason::kMirroredPart
                                              : Reason::kAccepted;
    part.reference = mesh_of(shape.solid);
    part.object = what == Draw::kMirrored ? mirrored(part.reference) : part.reference;
    part.from_mesh = random.coin();
    part.reference_points = static_cast<std::size_t>(random.one_of(10000, 40000));
    part.object_points = static_cast<std::size_t>(random.one_of(10000, 40000));
    part.noise = noise;
    const double leaf = random.coin() ? 0.002 : random.between(0.012, 0.03) * shape.radius;
    part.leaf = {leaf, leaf, leaf / 4};
    part.moved = {
        random.between(0.6, 1.7),
        random_rotation(seed + 5),
        {random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5)}};
    part.path = *path;
    part.seed = seed;
    return part;
  }
  throw std::logic_error("no room for a path");
}

tool_path_stretcher::StretchResult run(const DrawnPart& part) {
  tool_path_stretcher::StretchParameters parameters;
  parameters.leaf = part.leaf;
  const Surface reference =
      part.from_mesh
          ? tool_path_stretcher::surface_from_mesh(part.reference, part.leaf, "reference")
          : tool_path_stretcher::surface_from_cloud(
                sampled(part.reference, part.reference_points, part.noise, {}, 2 * part.seed + 1),
                part.leaf, "reference");
  const Surface object = tool_path_stretcher::surface_from_cloud(
      sampled(part.object, part.object_points, part.noise, part.moved, 2 * part.seed + 2),
      part.leaf, "object");
  return tool_path_stretcher::stretch(reference, object, part.path, parameters);
}

double farthest_off(const DrawnPart& part, const ToolPath& adapted) {
  return error_of(adapted, truth(part.path, none(), part.moved), {}).worst;
}

}  // namespace cases
