// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "edit/box.h"

#include <algorithm>

namespace scan_cell_rviz {

using cloud_preprocess::BoxShape;
using Eigen::Vector3d;

namespace {

constexpr double kThinnest = 1e-4;  // [m] chosen

}  // namespace

Vector3d outward(int face) {
  return (face % 2 == 0 ? -1.0 : 1.0) * Vector3d::Unit(face / 2);
}

Vector3d face_middle(const BoxShape& box, int face) {
  return box.pose * Vector3d(box.size[face / 2] / 2 * outward(face));
}

void drag_face(BoxShape& box, int face, const Vector3d& place) {
  const int axis = face / 2;
  const Vector3d out = outward(face);
  const double half = box.size[axis] / 2;
  const double wanted = out.dot(Vector3d(box.pose.inverse() * place));
  const double to = std::max(wanted, kThinnest - half);
  box.size[axis] = half + to;
  box.pose = box.pose * Eigen::Translation3d((to - half) / 2 * out);
}

BoxShape box_within(const cloud_preprocess::Cloud& cloud,
                    const cloud_preprocess::EditedCloud::Indices& kept) {
  constexpr double kEmpty = 0.1;  // [m]
  BoxShape box;
  box.size.setConstant(kEmpty);
  if (kept.empty()) return box;
  Eigen::AlignedBox3d bounds;
  for (const std::uint32_t i : kept)
    bounds.extend(Vector3d(cloud[i].getVector3fMap().cast<double>()));
  box.pose.translation() = bounds.center();
  box.size = (bounds.sizes() / 2).cwiseMax(kThinnest);
  return box;
}

}  // namespace scan_cell_rviz
