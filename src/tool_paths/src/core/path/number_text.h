// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tool_paths {

/// The shortest text that reads back as the same number.
std::string to_text(double number);

}  // namespace tool_paths
