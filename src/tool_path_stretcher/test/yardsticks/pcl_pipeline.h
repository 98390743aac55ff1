// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parts/scan.h"

namespace cases {

/// The result of PCL's own tools for a case, and whether they report success.
struct PclResult {
  ToolPath path;
  bool converged = false;
  Similarity similarity;
};

/// A public yardstick: the size from the clouds' extents, the pose from FPFH features and
/// pcl::SampleConsensusPrerejective as in PCL's tutorial "Robust pose estimation of rigid objects"
/// (its settings scaled to the part), refined by pcl::IterativeClosestPoint with free scale; the
/// transform moves the path. Its only check is hasConverged().
PclResult pcl_pipeline(const Points& reference, const Points& object, const ToolPath& path);

/// pcl::IterativeClosestPoint with free scale, starting from where the clouds lie.
PclResult pcl_icp(const Points& reference, const Points& object, double max_distance);

}  // namespace cases
