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

/// Reads what save_peaks() wrote. Element 0 is the first row in the file; rows that are not in the
/// file have no peak.
/// @throw scan_cell_common::FileError if it is missing or unreadable
/// @throw scan_cell_common::UnusableInput naming the line that makes no sense
PeakProfile load_peaks(const std::string& path);

/// The same from the text of such a file. @param name name of the text in error messages
PeakProfile parse_peaks(const std::string& text, const std::string& name);

}  // namespace tecnogamma_camera
