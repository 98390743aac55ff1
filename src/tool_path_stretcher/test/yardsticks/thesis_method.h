// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/scan.h"

namespace cases {

/// The thesis' general method (9.7) on whole clouds, without the suite's checks: it never refuses.
ToolPath thesis_method(const Points& reference, const Points& object, const ToolPath& path);

}  // namespace cases
