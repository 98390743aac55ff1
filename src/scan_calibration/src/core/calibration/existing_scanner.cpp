// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_calibration/existing_scanner.h"

#include <algorithm>

#include "scan_cell_common/files.h"

namespace scan_calibration {

ExistingScanner load_existing_scanner(const std::string& file) {
  const std::string text = scan_cell_common::read_file(file);
  return {file, text, scan_cell_common::parse_scanner_model(text, file)};
}

std::vector<std::string> kept_parts(const ExistingScanner& existing, bool lasers_alone,
                                    const std::vector<std::string>& lasers) {
  std::vector<std::string> parts;
  if (lasers_alone) parts = {"camera", "flange_to_camera"};
  for (std::size_t i = 0; i < existing.model.lasers.size(); ++i) {
    const std::string name = scan_cell_common::laser_name(i);
    const bool anew = std::find(lasers.begin(), lasers.end(), name) != lasers.end();
    if (existing.model.has_laser(i) && !anew) parts.push_back(name);
  }
  return parts;
}

}  // namespace scan_calibration
