// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/extrusion.h"

#include "parts/flat_face.h"

namespace scanner_views {

using Eigen::Vector2d;
using Eigen::Vector3d;

Mesh solid_of(const Extrusion& extrusion) {
  const cases::FlatFace face = cases::triangulated(extrusion.section, {});
  const auto front = [&](std::size_t i) {
    const Vector2d& at = face.points[i];
    return Vector3d(at.x(), -extrusion.length / 2 + extrusion.slant_front * at.x(), at.y());
  };
  const auto back = [&](std::size_t i) {
    const Vector2d& at = face.points[i];
    return Vector3d(at.x(), extrusion.length / 2 + extrusion.slant_back * at.x(), at.y());
  };
  MeshBuilder builder;
  for (const auto& [a, b, c] : face.triangles) {
    builder.triangle(front(a), front(b), front(c));
    builder.triangle(back(c), back(b), back(a));
  }
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const std::size_t next = (i + 1) % face.points.size();
    builder.quad(front(next), front(i), back(i), back(next));
  }
  return standing(builder.take());
}

Mesh ring_of(const std::vector<Points>& lines) {
  MeshBuilder builder;
  for (std::size_t i = 0; i < lines.size(); ++i)
    builder.band(lines[i], lines[(i + 1) % lines.size()]);
  return builder.take();
}

Mesh standing(Mesh mesh) {
  const Eigen::AlignedBox3d box = box_of(mesh);
  const Vector3d foot(box.center().x(), box.center().y(), box.min().z());
  return moved(std::move(mesh), [&](const Vector3d& at) -> Vector3d { return at - foot; });
}

}  // namespace scanner_views
