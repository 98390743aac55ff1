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

/// Two bodies that collide.
struct Collision {
  std::string moving;    //!< name of the shape or the link that moves with the robot
  std::string standing;  //!< name of the shape in the cell, or "part"
  /// [m] penetration depth, clearance included; NaN: unknown, since it is only known between
  /// spheres, boxes and half-spaces
  double depth = std::numeric_limits<double>::quiet_NaN();
};

/// The robot and its tool among the fixed bodies of the cell (FCL). Moving bodies are checked
/// against fixed ones, not against each other. For one thread at a time.
class CollisionScene {
 public:
  /// @param robot must outlive the scene
  /// @throw scan_cell_common::UnusableInput if the robot has no such frame or link
  CollisionScene(const RobotModel& robot, const CellShapes& shapes);
  ~CollisionScene();

  /// Sets the surface of the part, in base_link [m]; it is not a solid. Shapes in frame tool_tip
  /// may touch it.
  /// @throw scan_cell_common::UnusableInput if there are no triangles, a vertex is not finite, or a
  /// triangle refers to a vertex that does not exist
  void set_part(const std::vector<Eigen::Vector3d>& vertices,
                const std::vector<std::array<std::size_t, 3>>& triangles);

  /// The same for points: each point fills its cell of a grid.
  /// @param size [m] of a cell, at least 1e-4
  void set_part(const std::vector<Eigen::Vector3d>& points, double size);

  /// All collisions.
  /// @param joints [rad]
  std::vector<Collision> collisions(const Joints& joints,
                                    const Eigen::Isometry3d& flange_to_tip) const;

 private:
  struct Bodies;
  std::unique_ptr<Bodies> bodies_;
};

}  // namespace c4g_driver
