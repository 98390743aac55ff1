// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "c4g_driver/codec.h"

/// What the values of the controller's parameters mean, as JSON in the units of the wire.
namespace c4g_driver {

/// What a SET_PARAMETER asks for where it does the same as SET_OVERRIDE [%] or SET_LINSPEED [m/s].
/// @throw scan_cell_common::Refused if its value is no number
std::optional<double> override_of(const SetParameter& set);
std::optional<double> linear_speed_of(const SetParameter& set);

/// A parameter that is a word.
/// @throw scan_cell_common::ProtocolError if it is none
std::string word_of(const std::string& name, const std::string& text);

/// The parameter rotational_speed [rad/s].
/// @throw scan_cell_common::ProtocolError if it is no number above 0
double rotational_speed_of(const std::string& text);

}  // namespace c4g_driver
