// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "wire/codec.h"

/// The meaning of the controller's parameter values, JSON in the units of the wire.
namespace c4g_driver {

/// The value that a SET_PARAMETER sets if it is equivalent to SET_OVERRIDE [%] or SET_LINSPEED
/// [m/s].
/// @throw scan_cell_common::Refused if the value is not a number
std::optional<double> override_of(const SetParameter& set);
std::optional<double> linear_speed_of(const SetParameter& set);

/// The parameter motion_type: whether a MOVE_CARTESIAN is a joint motion.
/// @throw scan_cell_common::ProtocolError if it is neither "linear" nor "joint"
bool goes_in_joints(const std::string& text);

/// The parameter interpolation: whether A, E and R each change at their own rate along a line.
/// @throw scan_cell_common::ProtocolError if it is neither "linear" nor "euler"
bool turns_by_euler_angles(const std::string& text);

/// The parameter rotational_speed [rad/s].
/// @throw scan_cell_common::ProtocolError if it is not a number above 0
double rotational_speed_of(const std::string& text);

}  // namespace c4g_driver
