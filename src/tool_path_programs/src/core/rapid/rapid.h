// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// ABB RAPID, for controllers IRC5 and OmniCore.
const Language& rapid();

}  // namespace tool_path_programs
