// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// As Language::write.
WrittenProgram write_pdl2(const Program& program, const WriteSettings& settings);

}  // namespace tool_path_programs
