// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace part_recipes {

/// The time now, UTC, as 2026-11-25T12:13:14.123Z.
std::string utc_now();

/// The same for names of files, to the second: 20261125T121314Z.
std::string utc_stamp();

}  // namespace part_recipes
