// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/edited_cloud.h"

namespace scan_cell_rviz {

constexpr int kFaces = 6;  //!< of a box along its own x, y and z, the lower one first

/// Outward normal of a face, in the box's frame.
Eigen::Vector3d outward(int face);

/// Centre of a face [m], in the cloud's frame.
Eigen::Vector3d face_middle(const cloud_preprocess::BoxShape& box, int face);

/// Moves a face to where it was dragged; the opposite face stays. A box is at least 0.1 mm thick.
/// @param place [m] in the cloud's frame
void drag_face(cloud_preprocess::BoxShape& box, int face, const Eigen::Vector3d& place);

/// An initial box: half as long in each direction as the kept points, and centred on them.
/// @return a box of 0.1 m about the origin if no points are kept
cloud_preprocess::BoxShape box_within(const cloud_preprocess::Cloud& cloud,
                                      const cloud_preprocess::EditedCloud::Indices& kept);

}  // namespace scan_cell_rviz
