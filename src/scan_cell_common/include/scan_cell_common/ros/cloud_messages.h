// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "scan_cell_common/clouds/cloud_files.h"

namespace scan_cell_common {

/// x, y, z of a message's points, NaN included; its other fields are left out.
/// @throw UnusableInput if x, y or z is missing or no float32, or the data do not fit the size
Cloud from_message(const sensor_msgs::PointCloud2& message);

/// @param header passed through as it is
sensor_msgs::PointCloud2 to_message(const Cloud& cloud, const std_msgs::Header& header);

}  // namespace scan_cell_common
