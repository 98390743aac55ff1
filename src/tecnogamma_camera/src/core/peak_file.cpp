// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_file.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "scan_cell_common/files.h"

namespace tecnogamma_camera {

void save_peaks(const std::string& path, const PeakProfile& profile) {
  std::ostringstream file;
  file << "row,position,width,intensity\n" << std::fixed;
  for (int i = 0; i < profile.rows(); ++i) {
    if (std::isnan(profile.position[i])) continue;
    file << profile.first_row + i << ',' << std::setprecision(4) << profile.position[i] << ','
         << std::setprecision(2) << profile.width[i] << ',' << std::setprecision(1)
         << profile.intensity[i] << '\n';
  }
  scan_cell_common::save_text(path, file.str());
}

}  // namespace tecnogamma_camera
