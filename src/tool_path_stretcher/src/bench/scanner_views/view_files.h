// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scanner_views/view_case.h"

namespace scanner_views {

/// Writes a view for `stretch`: reference.ply, object.ply, path.csv and truth.csv, and scan.ply
/// with the object before cleaning, if it was cleaned. Points have laser, pass and viewpoint, as in
/// the suite's clouds.
/// @throw scan_cell_common::FileError
void write_files(const View& view, const std::string& folder);

}  // namespace scanner_views
