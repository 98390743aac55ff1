// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// Comau's language: .pdl, with the values of variables as text in .lsv. Dialects c5g and c4g,
/// which take the same programs. A speed left to the controller is read as the default of Move.
const Language& pdl2();

}  // namespace tool_path_programs
