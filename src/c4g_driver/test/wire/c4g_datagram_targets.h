// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan_cell_common/testing/fuzzing.h"

/// The readers of C4G datagrams, driver and emulated controller, for the fuzzers.
std::vector<scan_cell_common::FuzzTarget> c4g_datagram_targets();
