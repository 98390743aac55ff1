// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_preprocess/edited_cloud.h"

namespace scan_cell_rviz {

constexpr int kFaces = 6;  //!< of a box: along x, y and z of its own, the lower one first

/// In the box's frame.
Eigen::Vector3d outward(int face);

/// [m] In the cloud's frame.
Eigen::Vector3d face_middle(const cloud_preprocess::BoxShape& box, int face);

/// Puts a face where it was dragged to; the opposite one stays. No box gets thinner than 0.1 mm.
/// @param place [m] in the cloud's frame
void drag_face(cloud_preprocess::BoxShape& box, int face, const Eigen::Vector3d& place);

/// A box to begin with: half as long each way as what is kept, in its middle.
/// @return one of 0.1 m about the origin where nothing is kept
cloud_preprocess::BoxShape box_within(const cloud_preprocess::Cloud& cloud,
                                      const cloud_preprocess::EditedCloud::Indices& kept);

}  // namespace scan_cell_rviz
