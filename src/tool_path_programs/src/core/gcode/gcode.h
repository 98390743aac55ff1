// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// G-code for machines, and for robots that take it: dialects xyzabc, xyzac, xyzbc and xyz.
const Language& gcode();

}  // namespace tool_path_programs
