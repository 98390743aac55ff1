// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell_common/testing/fuzzing.h"

/// The decoders of smart cameras' frames and the reader of a folder's index, for the fuzzers.
std::vector<scan_cell_common::FuzzTarget> payload_targets();
