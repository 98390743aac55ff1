// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tecnogamma_camera/peak_profile.h"

namespace tecnogamma_camera {

/// Writes `row,position,width,intensity` with a header line; rows without a peak are left out.
/// The file is written whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_peaks(const std::string& path, const PeakProfile& profile);

}  // namespace tecnogamma_camera
