// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell_common/testing/fuzzing.h"

/// The readers of tool paths and path edits, for the fuzzers.
std::vector<scan_cell_common::FuzzTarget> tool_path_file_targets();
