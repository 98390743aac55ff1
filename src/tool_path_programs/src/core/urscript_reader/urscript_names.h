// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

namespace tool_path_programs {

/// Whether a word is reserved by URScript, so no program, function or variable may have it as a
/// name.
bool is_urscript_keyword(std::string_view word);

/// Whether it is a controller function that neither moves the robot to a place nor changes its
/// tool.
bool is_urscript_function_without_motion(std::string_view name);

/// Whether it is a controller function that moves, or changes the frame of poses: movel, set_tcp,
/// speedj.
bool is_urscript_function_with_motion(std::string_view name);

/// Why a name is not allowed in a script; empty: it is.
std::string fault_of_urscript_name(const std::string& name);

/// The nearest allowed name.
std::string urscript_name_like(const std::string& name);

}  // namespace tool_path_programs
