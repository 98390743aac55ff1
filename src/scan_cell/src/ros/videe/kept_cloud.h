// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/ScanResult.h>

#include <string>

namespace scan_cell {

/// A cloud for a client that has no ROS.
struct KeptCloud {
  std::string file;     //!< PLY [m]
  std::string machine;  //!< that has the file: name or address, as ROS knows it
};

/// Saves a scan's cloud in `folder` under the scan's name. A cloud that was too large for a message
/// stays in the triangulation's file.
/// @param triangulation name of its node
/// @throw scan_cell_common::Refused with the scan's own message, if nothing was captured
/// @throw scan_cell_common::Error if the cloud cannot be saved
KeptCloud keep_cloud(const scan_cell_msgs::ScanResult& scan, const std::string& folder,
                     const std::string& triangulation);

}  // namespace scan_cell
