// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scanner_views/view_case.h"

namespace scanner_views {

/// Writes a view as `stretch` reads it: reference.ply, object.ply, path.csv and
/// truth.csv; of an object that was cleaned also scan.ply, before that. Points carry laser, pass
/// and the place they were seen from, as in the suite's clouds.
/// @throw scan_cell_common::FileError
void write_files(const View& view, const std::string& folder);

}  // namespace scanner_views
