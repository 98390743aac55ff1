// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/surface/part_mesh.h"

namespace part_recipes {

/// A centripetal Catmull-Rom spline through points (Yuksel, Schaefer, Keyser 2011): without cusps
/// or loops between them. An open spline continues beyond its ends with its end sides mirrored.
class CatmullRom {
 public:
  /// @param points [m] two or more, for a closed spline three or more; neighbours in different
  /// places
  CatmullRom(const path_design::Points& points, bool closed) : points_(points), closed_(closed) {}

  /// Number of pieces, from point to point.
  std::size_t pieces() const { return points_.size() - (closed_ ? 0 : 1); }

  /// A place of a piece [m].
  /// @param share 0: at its first point; 1: at the next
  Eigen::Vector3d at(std::size_t piece, double share) const;

 private:
  Eigen::Vector3d point(std::ptrdiff_t i) const;

  const path_design::Points points_;
  const bool closed_;
};

}  // namespace part_recipes
