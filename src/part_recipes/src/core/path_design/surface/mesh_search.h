// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "path_design/surface/part_mesh.h"

namespace part_recipes::path_design {

/// The place on a surface that is nearest to a point.
struct Foot {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    //!< [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  //!< of the smooth surface, unit length
  double distance = 0;                                //!< [m] from the given point
  std::uint32_t triangle = kNoTriangle;               //!< in which it lies
};

/// Searches the triangles of a mesh.
class MeshSearch {
 public:
  /// @param mesh must outlive it
  explicit MeshSearch(const PartMesh& mesh);
  ~MeshSearch();
  MeshSearch(const MeshSearch&) = delete;
  MeshSearch& operator=(const MeshSearch&) = delete;

  Foot nearest(const Eigen::Vector3d& point) const;  //!< @param point [m]

  /// Whether something lies in front of a place on the surface.
  /// @param place [m]
  /// @param towards the viewer, unit length
  bool is_hidden(const Eigen::Vector3d& place, const Eigen::Vector3d& towards) const;

  const PartMesh& mesh() const;  //!< that is searched

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

/// [m] along the surface from one place on it to another: the way over the surface above the line
/// between them, which is shortest on planes, and across or along cylinders.
double length_along(const MeshSearch& surface, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& to);

}  // namespace part_recipes::path_design
