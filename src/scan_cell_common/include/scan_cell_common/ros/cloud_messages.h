// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"

namespace scan_cell_common {

/// All fields of a message that have one value a point, where they lie: the message must outlive
/// them.
/// @throw UnusableInput if the data do not fit the size, or are big endian
CloudView view_of(const sensor_msgs::PointCloud2& message);

/// x, y, z of a message's points, NaN included; its other fields are left out.
/// @throw UnusableInput as view_of() and places_of()
Cloud from_message(const sensor_msgs::PointCloud2& message);

/// @param header passed through as it is
sensor_msgs::PointCloud2 to_message(const Cloud& cloud, const std_msgs::Header& header);

/// With all fields. @param header passed through as it is
sensor_msgs::PointCloud2 to_message(FieldedCloud cloud, const std_msgs::Header& header);

}  // namespace scan_cell_common
