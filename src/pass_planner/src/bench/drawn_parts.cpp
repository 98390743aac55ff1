// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_parts.h"

#include <cmath>

#include "scan_cell_sim/scene.h"

namespace pass_planner {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using scan_cell_sim::Part;
using scan_cell_sim::Scene;
using scan_cell_sim::World;

Part draw_shape(std::mt19937_64& random, std::size_t kind) {
  Part part;
  part.name = "part";
  if (kind < 2) {
    scan_cell_sim::FrameShape frame;
    frame.size = {draw(random, 0.14, 0.2), draw(random, 0.1, 0.13)};
    part.shape = frame;
  } else if (kind == 2) {
    part.shape = scan_cell_sim::BoxShape{
        {draw(random, 0.1, 0.16), draw(random, 0.05, 0.09), draw(random, 0.025, 0.05)}};
  } else {
    part.shape = scan_cell_sim::ElbowShape{draw(random, 0.015, 0.025), draw(random, 0.05, 0.08),
                                           draw(random, 0.04, 0.08)};
  }
  return part;
}

/// With z against the surface, x level.
Isometry3d tool_at(const Vector3d& point, const Vector3d& normal) {
  const Vector3d z = -normal;
  const Vector3d x = Vector3d::UnitZ().cross(z).normalized();
  Isometry3d pose;
  pose.translation() = point;
  pose.linear() << x, z.cross(x), z;
  return pose;
}

/// Where level rays towards the axis of a part first meet it, all around.
scan_cell_sim::ToolPath flank_path(const Part& part, double height) {
  constexpr double kFar = 1;      // [m]
  constexpr int kWaypoints = 72;  // one every 5 degrees
  const Scene scene(World{std::nullopt, std::nullopt, {part}});
  scan_cell_sim::ToolPath path;
  for (int i = 0; i < kWaypoints; ++i) {
    const double angle = 2 * M_PI * i / kWaypoints;
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    const auto hit = scene.first_hit(kFar * out + height * Vector3d::UnitZ(), -out);
    if (hit && hit->normal.z() < 0.9) path.push_back(tool_at(hit->point, hit->normal));
  }
  return path;
}

double height_of(const Part& part) {
  if (const auto* box = std::get_if<scan_cell_sim::BoxShape>(&part.shape)) return box->size.z();
  if (const auto* elbow = std::get_if<scan_cell_sim::ElbowShape>(&part.shape))
    return 2 * elbow->pipe_radius;
  return 0.02;  // [m] of a frame, about
}

}  // namespace

double draw(std::mt19937_64& random, double least, double most) {
  return least + (most - least) * std::ldexp(static_cast<double>(random() >> 11U), -53);
}

DrawnPart draw_part(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::size_t kind = seed % 4;
  const char* const names[] = {"frame, crest", "frame, flank", "box, flank", "elbow, flank"};
  DrawnPart drawn;
  drawn.name = names[kind];
  drawn.reference = draw_shape(random, kind);
  constexpr double kSpacing = 0.008;  // [m] of waypoints
  // Only the upper half: the part itself can hide what is below.
  drawn.path = kind == 0 ? scan_cell_sim::crest_path(drawn.reference, kSpacing)
                         : flank_path(drawn.reference,
                                      draw(random, 0.55, 0.75) * height_of(drawn.reference));
  Part part = drawn.reference;
  part.scale = draw(random, 0.85, 1.1);
  part.pose = Eigen::Translation3d(draw(random, -0.05, 0.05), draw(random, -0.05, 0.05), 0) *
              AngleAxisd(draw(random, -M_PI, M_PI), Vector3d::UnitZ());
  drawn.world.floor = scan_cell_sim::Floor{};
  drawn.world.parts = {part};
  for (const Isometry3d& pose : drawn.path) {
    Isometry3d moved = part.pose * pose;
    moved.translation() = part.to_world(pose.translation());
    drawn.true_path.push_back(moved);
  }
  return drawn;
}

scan_cell::ScanPass draw_line(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  // Turned about where the light meets the floor.
  const auto flange_at = [&](double x, double y, double pitch, double roll) {
    return Eigen::Translation3d(x, y, 0) * AngleAxisd(M_PI, Vector3d::UnitX()) *
           AngleAxisd(pitch, Vector3d::UnitY()) * AngleAxisd(roll, Vector3d::UnitX()) *
           Eigen::Translation3d(0, 0, -0.595);
  };
  const double y = draw(random, -0.03, 0.03), pitch = draw(random, -0.3, 0.3),
               roll = draw(random, -0.3, 0.3);
  scan_cell::ScanPass pass;
  pass.poses = {flange_at(-0.18, y, pitch, roll), flange_at(draw(random, 0, 0.18), y, pitch, roll)};
  pass.speed = 0.06;
  pass.rate = 100;
  pass.lasers = static_cast<scan_cell::PassLasers>(seed % 3);
  return pass;
}

SurfaceShape shape_of(const scan_cell_sim::Mesh& mesh) {
  SurfaceShape shape;
  shape.points = mesh.vertices;
  shape.triangles = mesh.triangles;
  return shape;
}

std::vector<Vector3d> positions_of(const scan_cell_sim::ToolPath& path) {
  std::vector<Vector3d> positions;
  for (const Isometry3d& pose : path)
    positions.push_back(pose.translation());
  return positions;
}

}  // namespace pass_planner
