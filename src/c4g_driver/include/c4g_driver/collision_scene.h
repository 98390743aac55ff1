// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "c4g_driver/cell_shapes.h"
#include "c4g_driver/robot_model.h"

namespace c4g_driver {

/// Two things that run into each other.
struct Collision {
  std::string moving;    //!< name of the shape or the link that moves with the robot
  std::string standing;  //!< name of the shape in the cell, or "part"
  /// [m] how deep, clearance included; NaN: not known, as it is only between spheres, boxes and
  /// half-spaces
  double depth = std::numeric_limits<double>::quiet_NaN();
};

/// The robot and its tool among what stands in the cell (FCL). What moves is looked at against what
/// stands, not against other things that move. For one thread at a time.
class CollisionScene {
 public:
  /// @param robot outlives it
  /// @throw scan_cell_common::UnusableInput if the robot has no such frame or link
  CollisionScene(const RobotModel& robot, const CellShapes& shapes);
  ~CollisionScene();

  /// Takes the surface of the part, in base_link [m]; its inside does not count. Shapes in frame
  /// tool_tip may touch it.
  /// @throw scan_cell_common::UnusableInput if there are none, not finite, or triangles of others
  void set_part(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<std::array<std::size_t, 3>>& triangles);

  /// The same for points: each fills its cell of a grid.
  /// @param size [m] of a cell, from 1e-4 up
  void set_part(const std::vector<Eigen::Vector3d>& points, double size);

  /// All that collide.
  /// @param joints [rad]
  std::vector<Collision> collisions(const Joints& joints,
                                    const Eigen::Isometry3d& flange_to_tip) const;

 private:
  struct Bodies;
  std::unique_ptr<Bodies> bodies_;
};

}  // namespace c4g_driver
