// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/terrace.h"

#include <numeric>

#include "parts/flat_face.h"

namespace scanner_views {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d at_height(const Vector2d& point, double z) {
  return {point.x(), point.y(), z};
}

Points at_height(const Loop& loop, double z) {
  Points points;
  for (const Vector2d& point : loop)
    points.push_back(at_height(point, z));
  return points;
}

/// The loop scaled about the mean of its corners.
Loop scaled(Loop loop, double scale) {
  const Vector2d sum = std::accumulate(loop.begin(), loop.end(), Vector2d(0, 0));
  const Vector2d middle = sum / static_cast<double>(loop.size());
  for (Vector2d& point : loop)
    point = middle + scale * (point - middle);
  return loop;
}

/// [m] from the mean of the corners to the farthest one
double radius_of(const Loop& loop) {
  const Vector2d sum = std::accumulate(loop.begin(), loop.end(), Vector2d(0, 0));
  double radius = 0;
  for (const Vector2d& point : loop)
    radius = std::max(radius, (point - sum / static_cast<double>(loop.size())).norm());
  return radius;
}

/// The loop in counter-clockwise order.
Loop left_turning(const Loop& loop) {
  const cases::FlatFace face = cases::triangulated(loop, {});
  return face.points;
}

std::vector<Loop> outlines_of(const std::vector<Terrace>& terraces) {
  std::vector<Loop> outlines;
  for (const Terrace& terrace : terraces)
    outlines.push_back(terrace.outline);
  return outlines;
}

void add_holes(const Terrace& terrace, std::vector<Loop>& holes) {
  for (const Terrace& on_it : terrace.on_it) {
    if (on_it.through) holes.push_back(on_it.outline);
    add_holes(on_it, holes);
  }
}

void add_face(const Loop& outline, const std::vector<Loop>& holes, double z, bool upwards,
              MeshBuilder& builder) {
  const cases::FlatFace face = cases::triangulated(outline, holes);
  for (const auto& [a, b, c] : face.triangles) {
    const Vector3d first = at_height(face.points[a], z), second = at_height(face.points[b], z),
                   third = at_height(face.points[c], z);
    upwards ? builder.triangle(first, second, third) : builder.triangle(third, second, first);
  }
}

void add(const Terrace& terrace, double from, MeshBuilder& builder) {
  const Loop foot = left_turning(terrace.outline);
  if (terrace.through) {
    builder.band(at_height(foot, from), at_height(foot, 0));
    return;
  }
  const Loop shoulder = scaled(foot, terrace.taper);
  builder.band(at_height(foot, from), at_height(shoulder, terrace.height - terrace.chamfer));
  const Loop rim = scaled(shoulder, 1 - terrace.chamfer / radius_of(shoulder));
  if (terrace.chamfer > 0) {
    builder.band(at_height(shoulder, terrace.height - terrace.chamfer),
                 at_height(rim, terrace.height));
  }
  add_face(terrace.chamfer > 0 ? rim : shoulder, outlines_of(terrace.on_it), terrace.height, true,
           builder);
  for (const Terrace& on_it : terrace.on_it)
    add(on_it, terrace.height, builder);
}

}  // namespace

Mesh solid_of(const Terrace& base) {
  MeshBuilder builder;
  std::vector<Loop> holes;
  add_holes(base, holes);
  add_face(base.outline, holes, 0, false, builder);
  add(base, 0, builder);
  return builder.take();
}

Loop shifted(Loop loop, const Vector2d& by) {
  for (Vector2d& point : loop)
    point += by;
  return loop;
}

Loop turned(Loop loop, double angle) {
  for (Vector2d& point : loop)
    point = Eigen::Rotation2Dd(angle) * point;
  return loop;
}

Terrace hole(const Vector2d& at, double radius) {
  constexpr int kCorners = 32;
  Terrace terrace;
  terrace.outline = cases::circle(at, radius, kCorners);
  terrace.through = true;
  return terrace;
}

}  // namespace scanner_views
