// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/scanner/surroundings.h"

#include "parts/solids.h"
#include "scan_cell_sim/scene.h"
#include "scanner_views/parts/terrace.h"

namespace scanner_views {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Mesh floor_below(const Eigen::AlignedBox3d& box) {
  constexpr double kBeyond = 0.3;  // [m] around the part
  const Vector3d least = box.min() - Vector3d(kBeyond, kBeyond, 0);
  const Vector3d most = box.max() + Vector3d(kBeyond, kBeyond, 0);
  const double z = box.min().z();
  MeshBuilder builder;
  builder.quad({least.x(), least.y(), z}, {most.x(), least.y(), z}, {most.x(), most.y(), z},
               {least.x(), most.y(), z});
  return builder.take();
}

Mesh block(const Vector3d& least, const Vector3d& most) {
  const Vector3d size = most - least;
  const Mesh mesh = solid_of(Terrace{cases::rectangle_loop(size.x(), size.y()), size.z()});
  const Vector3d foot((least.x() + most.x()) / 2, (least.y() + most.y()) / 2, least.z());
  return moved(mesh, [&](const Vector3d& at) -> Vector3d { return at + foot; });
}

/// A post beside the part with a finger that reaches in along x and holds the part down.
/// @param side 1: from the side of greatest x; -1: from the other
void add_clamp(const scan_cell_sim::Scene& part, const Eigen::AlignedBox3d& box, double side,
               double y, std::vector<Mesh>& meshes) {
  constexpr double kReach = 0.015;   // [m] of the finger over the part
  constexpr double kHalf = 0.008;    // [m] of its width
  constexpr double kBeside = 0.012;  // [m] of the post from the part
  constexpr double kThick = 0.010;   // [m]
  double top = box.min().z(), rim = 0;
  bool found = false;
  // Moves inwards to where the part begins.
  for (double in = 0; in < box.sizes().x() / 2 && !found; in += 0.002) {
    const double x = (side > 0 ? box.max().x() : box.min().x()) - side * in;
    const auto hit = part.first_hit({x, y, box.max().z() + 0.1}, -Vector3d::UnitZ());
    if (!hit) continue;
    rim = x;
    found = true;
  }
  if (!found) return;
  for (double in = 0; in <= kReach; in += 0.001) {
    for (const double aside : {-kHalf, 0.0, kHalf}) {
      const auto hit =
          part.first_hit({rim - side * in, y + aside, box.max().z() + 0.1}, -Vector3d::UnitZ());
      if (hit) top = std::max(top, hit->point.z());
    }
  }
  const double inner = rim - side * kReach, outer = rim + side * (kBeside + 0.02);
  const double post = rim + side * kBeside;
  meshes.push_back(block({std::min(inner, outer), y - kHalf, top},
                         {std::max(inner, outer), y + kHalf, top + kThick}));
  meshes.push_back(block({std::min(post, outer), y - kHalf, box.min().z()},
                         {std::max(post, outer), y + kHalf, top}));
}

}  // namespace

std::vector<Mesh> meshes_of(const Surroundings& surroundings, const Mesh& part, const Mesh& alike,
                            Draws& draws) {
  const Eigen::AlignedBox3d box = box_of(part);
  std::vector<Mesh> meshes;
  if (surroundings.floor) meshes.push_back(floor_below(box));
  if (surroundings.clamps) {
    const scan_cell_sim::Scene scene({part}, 1);
    for (const double side : {-1.0, 1.0}) {
      const double y = box.center().y() + draws.between(-0.25, 0.25) * box.sizes().y();
      add_clamp(scene, box, side, y, meshes);
    }
  }
  if (surroundings.neighbour) {
    constexpr double kGap = 0.025;  // [m] more than the gap by which cleaning separates objects
    const double turn = draws.between(-0.3, 0.3);
    const Mesh lying = moved(alike, [&](const Vector3d& at) -> Vector3d {
      return Eigen::AngleAxisd(turn, Vector3d::UnitZ()) * at;
    });
    const Eigen::AlignedBox3d its = box_of(lying);
    const Vector3d by(box.center().x() - its.center().x(), box.max().y() + kGap - its.min().y(),
                      box.min().z() - its.min().z());
    meshes.push_back(moved(lying, [&](const Vector3d& at) -> Vector3d { return at + by; }));
  }
  return meshes;
}

}  // namespace scanner_views
