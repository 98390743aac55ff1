// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"

namespace scan_cell_common {

/// A view of all fields of a message that have one value per point. The message must outlive it.
/// @throw UnusableInput if the data does not match the size, or is big endian
CloudView view_of(const sensor_msgs::PointCloud2& message);

/// x, y, z of a message's points, NaN included, without the other fields.
/// @throw UnusableInput as view_of() and places_of()
Cloud from_message(const sensor_msgs::PointCloud2& message);

/// @param header passed through unchanged
sensor_msgs::PointCloud2 to_message(const Cloud& cloud, const std_msgs::Header& header);

/// With all fields. @param header passed through unchanged
sensor_msgs::PointCloud2 to_message(FieldedCloud cloud, const std_msgs::Header& header);

}  // namespace scan_cell_common
