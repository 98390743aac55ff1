// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tecnogamma_camera/peak_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>

#include "scan_cell_common/errors.h"

namespace tecnogamma_camera {

void save_peaks(const std::string& path, const PeakProfile& profile) {
  const std::string partial = path + ".partial";
  std::ofstream file(partial);
  file << "row,position,width,intensity\n" << std::fixed;
  for (int i = 0; i < profile.rows(); ++i) {
    if (std::isnan(profile.position[i])) continue;
    file << profile.first_row + i << ',' << std::setprecision(4) << profile.position[i] << ','
         << std::setprecision(1) << profile.width[i] << ',' << profile.intensity[i] << '\n';
  }
  file.close();
  std::error_code failure;
  if (file) std::filesystem::rename(partial, path, failure);
  if (!file || failure) {
    std::filesystem::remove(partial, failure);
    throw scan_cell_common::FileError(path, "cannot be written",
                                      "check the folder and its permissions");
  }
}

}  // namespace tecnogamma_camera
