// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_path_programs/language.h"

namespace tool_path_programs {

/// KUKA's language: .src with .dat. Dialects krc4, krc2. A speed left to the controller is read as
/// the default of Move; fly-by that is not a length (C_PTP, C_VEL, C_ORI) as zone 0.
const Language& krl();

}  // namespace tool_path_programs
