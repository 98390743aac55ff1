// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell_common/testing/fuzzing.h"

/// The reader of scanner models, with the models to be mutated.
std::vector<scan_cell_common::FuzzTarget> scanner_model_targets();
