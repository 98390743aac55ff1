// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace pass_planner {

/// What a surface is made of.
struct SurfaceShape {
  std::vector<Eigen::Vector3d> points;                  //!< [m] corners of the triangles
  std::vector<std::array<std::uint32_t, 3>> triangles;  //!< indices of the points
  double clearance = 3e-4;  //!< [m] nothing nearer to a place shadows it: facets, single precision
};

/// A square on each point of a cloud, large enough to leave no gap between neighbours.
/// @param normals unit length, either sign
/// @param spacing [m] of neighbouring points
SurfaceShape squares_on(const std::vector<Eigen::Vector3d>& points,
                        const std::vector<Eigen::Vector3d>& normals, double spacing);

/// Reads a mesh or a cloud as tool_path_stretcher::load_surface() does.
/// @param leaf [m] grid reduction of a cloud
/// @param metres_per_unit of the file's lengths
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
SurfaceShape load_shape(const std::string& path, const Eigen::Vector3d& leaf,
                        double metres_per_unit = 1);

/// The shape, moved by a similarity.
SurfaceShape placed(const SurfaceShape& shape, const tool_path_stretcher::Similarity& similarity);

/// A surface that stands in the way of rays. Immutable; all methods may be called from several
/// threads at once.
class Surface {
 public:
  /// A place on the surface.
  struct Place {
    Eigen::Vector3d point;   //!< [m]
    Eigen::Vector3d normal;  //!< unit length, either sign
    double distance = 0;     //!< [m] from the point that was asked for
  };

  /// @throw scan_cell_common::UnusableInput if it has no triangle
  explicit Surface(const SurfaceShape& shape);
  ~Surface();
  Surface(Surface&&) noexcept;             //!< takes over the other's shape
  Surface& operator=(Surface&&) noexcept;  //!< takes over the other's shape

  /// The place on the surface nearest to a point [m].
  Place nearest(const Eigen::Vector3d& point) const;

  /// The first obstacle on the straight way from a place on the surface to an eye or a light; none
  /// if the way is free.
  std::optional<Eigen::Vector3d> obstacle(const Eigen::Vector3d& on_surface,
                                          const Eigen::Vector3d& eye) const;

 private:
  struct Implementation;

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pass_planner
