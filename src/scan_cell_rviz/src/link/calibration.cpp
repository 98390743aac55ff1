// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "link/cell_link.h"
#include "scan_cell_common/files/sha256.h"
#include "signs/signs.h"

namespace scan_cell_rviz {

/// Runs in the worker: a master that hangs must not block anything else.
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
    hash.clear();  // the sign says that the file is not here
  }
  show(Device::kCalibration, calibration_sign(file, hash, age));
}

/// Runs in the worker, too.
void CellLink::look_at_robot() {
  std::string urdf;
  RobotLimits limits;
  ros::param::get("/robot_description", urdf);
  ros::param::get(names_.robot + "/joint_lower", limits.lower);
  ros::param::get(names_.robot + "/joint_upper", limits.upper);
  const RobotLimitsGiven given{urdf, limits.lower, limits.upper};
  if (given == limits_given_) return;
  limits_given_ = given;  // errors in it are reported once
  limits.of_robot = limits_in(urdf);
  Q_EMIT limitsCame(limits);
}

}  // namespace scan_cell_rviz
