// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

namespace part_recipes {

/// How the outside of a reference is known.
enum class OutsideKnownBy {
  kClosedMesh,  //!< the mesh encloses the part
  kViewpoints,  //!< the scan says from where each point was seen (vp_x, vp_y, vp_z)
  kUpwards,     //!< from nothing: the side that faces +z of the reference's frame
};

/// For a person and for files: "closed mesh", "viewpoints of the scan", "+z of the reference".
std::string to_string(OutsideKnownBy outside);

/// Distance up to which a surface counts as near to a point.
struct Reach {
  double normal = 0;   //!< [m] along the surface's normal
  double lateral = 0;  //!< [m] along the surface, beyond its border
};

/// The surface of the reference part, from which deviations are measured. Lengths and places are in
/// the reference's frame.
class ReferenceSurface {
 public:
  /// Points on the surface, spread evenly over it.
  struct Samples {
    std::vector<Eigen::Vector3d> points;   //!< [m]
    std::vector<Eigen::Vector3d> normals;  //!< unit length, of free sign
    double spacing = 0;                    //!< [m] typical distance of neighbours
  };

  /// Reads a mesh or a cloud, as scan_cell_common::load_mesh() and load_cloud() do.
  /// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput
  static std::unique_ptr<ReferenceSurface> load(const std::string& file, double metres_per_unit);

  virtual ~ReferenceSurface() = default;
  ReferenceSurface(const ReferenceSurface&) = delete;
  ReferenceSurface& operator=(const ReferenceSurface&) = delete;

  /// Distance [m] of a point from the surface, positive outside; NaN if no surface is near or its
  /// outside is not known.
  virtual double signed_distance(const Eigen::Vector3d& point, const Reach& reach) const = 0;

  const Samples& samples() const { return samples_; }           //!< of the surface
  OutsideKnownBy outside_known_by() const { return outside_; }  //!< the sign of the distance

 protected:
  ReferenceSurface(Samples samples, OutsideKnownBy outside);

 private:
  Samples samples_;
  OutsideKnownBy outside_;
};

}  // namespace part_recipes
