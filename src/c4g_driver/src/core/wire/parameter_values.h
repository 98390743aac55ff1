// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "wire/codec.h"

/// What the values of the controller's parameters mean, as JSON in the units of the wire.
namespace c4g_driver {

/// What a SET_PARAMETER asks for where it does the same as SET_OVERRIDE [%] or SET_LINSPEED [m/s].
/// @throw scan_cell_common::Refused if its value is no number
std::optional<double> override_of(const SetParameter& set);
std::optional<double> linear_speed_of(const SetParameter& set);

/// The parameter motion_type: whether a MOVE_CARTESIAN goes in joints.
/// @throw scan_cell_common::ProtocolError if it is neither "linear" nor "joint"
bool goes_in_joints(const std::string& text);

/// The parameter interpolation: whether A, E and R go each at its own rate along a line.
/// @throw scan_cell_common::ProtocolError if it is neither "linear" nor "euler"
bool turns_by_euler_angles(const std::string& text);

/// The parameter rotational_speed [rad/s].
/// @throw scan_cell_common::ProtocolError if it is no number above 0
double rotational_speed_of(const std::string& text);

}  // namespace c4g_driver
