// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "link/cell_link.h"
#include "scan_cell_common/files/sha256.h"
#include "signs/signs.h"

namespace scan_cell_rviz {

/// Aside: a master that hangs must not hold up anything else.
void CellLink::look_at_calibration() {
  std::string file, hash;
  ros::param::get(names_.frames + "/scanner_file", file);
  double age = 0;
  try {
    if (!file.empty()) {
      hash = scan_cell_common::sha256_of_file(file);
      const auto written = std::filesystem::last_write_time(file);
      age = std::chrono::duration<double>(std::filesystem::file_time_type::clock::now() - written)
                .count();
    }
  } catch (const std::exception&) {
    hash.clear();  // the sign says that it is not here
  }
  show(Device::kCalibration, calibration_sign(file, hash, age));
}

/// Aside, likewise.
void CellLink::look_at_robot() {
  std::string urdf;
  ros::param::get("/robot_description", urdf);
  if (urdf == robot_description_) return;
  robot_description_ = urdf;
  Q_EMIT limitsCame(limits_in(urdf));
}

}  // namespace scan_cell_rviz
