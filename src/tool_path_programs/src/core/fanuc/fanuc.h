// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// FANUC TP as text (LS files). Dialects: cnt, where fly-by is a share, and cr, where it is a
/// length (option Corner Region).
const Language& fanuc();

}  // namespace tool_path_programs
