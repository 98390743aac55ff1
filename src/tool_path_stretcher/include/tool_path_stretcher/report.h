// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tool_path_stretcher/stretcher.h"

namespace tool_path_stretcher {

/// The report of docs/tool_path_stretcher.md as JSON text.
std::string report_to_json(const StretchResult& result);

/// Writes it, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_report(const std::string& path, const StretchResult& result);

}  // namespace tool_path_stretcher
