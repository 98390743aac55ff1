// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "c4g_driver/motion.h"
#include "c4g_driver/robot_state.h"

namespace c4g_driver {

/// One direction in which a person moves the robot by a button.
struct Jog {
  /// What moves.
  enum class Kind {
    kJoint,   //!< one joint
    kBase,    //!< the flange, along or about an axis of the base
    kFlange,  //!< the flange, along or about an axis of its own
  };
  Kind kind = Kind::kJoint;  //!< what moves
  int axis = 0;              //!< 0 .. 5: the joint; or x, y, z, then the rotations about them
  int direction = 1;         //!< 1 or -1

  /// Whether both are the same direction.
  friend bool operator==(const Jog& a, const Jog& b) {
    return a.kind == b.kind && a.axis == b.axis && a.direction == b.direction;
  }
};

/// A motion that covers this share of the longest way in one direction.
/// @param share 0 .. 1 of half a metre or of a quarter turn
/// @throw scan_cell_common::Refused if the axis or the direction is invalid
Motion jog_motion(const RobotState& from, const Jog& jog, double share);

}  // namespace c4g_driver
