// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tool_path_programs {

/// What URScript keeps for itself and no program, function or variable may be called.
bool is_urscript_keyword(std::string_view word);

/// Functions of the controller that neither move the robot to a place nor change its tool.
bool is_urscript_function_without_motion(std::string_view name);

/// Functions of the controller that move, or change what poses are of: movel, set_tcp, speedj.
bool is_urscript_function_with_motion(std::string_view name);

/// Why a name cannot stand in a script; empty: it can.
std::string fault_of_urscript_name(const std::string& name);

/// The nearest name that can.
std::string urscript_name_like(const std::string& name);

}  // namespace tool_path_programs
