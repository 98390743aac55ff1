// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "scan_cell_sim/world.h"

namespace scan_cell_sim {

/// The surfaces of a world, for casting rays. Immutable; all methods may be called from several
/// threads at once.
class Scene {
 public:
  /// Largest distance of a triangle from the true surface.
  static constexpr double kTolerance = 4e-6;  //!< [m] chosen

  /// Where a ray meets a surface.
  struct Hit {
    Eigen::Vector3d point;   //!< [m] in world
    Eigen::Vector3d normal;  //!< unit vector, on the side the ray came from
    double distance;         //!< [m] from the ray's origin
    double reflectance;      //!< 0 .. 1
    unsigned surface;        //!< numbers floor, board and parts, or the surfaces given
  };

  /// @throw scan_cell_common::UnusableInput if a part's deformation folds it
  explicit Scene(const World& world);

  /// A scene of one part alone, without the floor.
  /// @throw scan_cell_common::UnusableInput as above, or if there is no such part
  Scene(const World& world, const std::string& part);

  /// A scene of surfaces that are not shapes of the simulator.
  /// @param surfaces [m] numbered from 0 in Hit::surface
  /// @param reflectance 0 .. 1, of all
  Scene(const std::vector<Mesh>& surfaces, double reflectance);

  ~Scene();
  Scene(Scene&&) noexcept;             //!< takes over the other's surfaces
  Scene& operator=(Scene&&) noexcept;  //!< takes over the other's surfaces

  /// First surface along a ray. `direction` is a unit vector.
  std::optional<Hit> first_hit(const Eigen::Vector3d& origin,
                               const Eigen::Vector3d& direction) const;

  /// The calibration board, if there is one.
  const std::optional<Checkerboard>& board() const;

  /// Whether the surface that was hit is the calibration board's.
  bool is_on_board(const Hit& hit) const;

  /// Whether nothing stands between two points, the first of which lies on a surface.
  bool sees(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& eye) const;

  /// Distance [m] from a point to the nearest surface; infinite if there is none.
  double distance_to_surface(const Eigen::Vector3d& point) const;

  /// The triangles that rays meet, in world.
  const std::vector<Mesh>& meshes() const;

 private:
  struct Implementation;

  std::unique_ptr<Implementation> implementation_;
};

}  // namespace scan_cell_sim
