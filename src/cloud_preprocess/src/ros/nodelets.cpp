// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pluginlib/class_list_macros.hpp>

#include "clean_nodelet.h"
#include "cloud_preprocess/floor_removal.h"
#include "cloud_preprocess/grid_reduction.h"
#include "cloud_preprocess/object_isolation.h"
#include "cloud_preprocess/outlier_removal.h"
#include "stage_nodelet.h"

namespace cloud_preprocess {

using Floor = NodeletOf<FloorRemoval>;
using Outliers = NodeletOf<OutlierRemoval>;
using Isolate = NodeletOf<ObjectIsolation>;
using Grid = NodeletOf<GridReduction>;

}  // namespace cloud_preprocess

PLUGINLIB_EXPORT_CLASS(cloud_preprocess::CleanNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(cloud_preprocess::Floor, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(cloud_preprocess::Outliers, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(cloud_preprocess::Isolate, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(cloud_preprocess::Grid, nodelet::Nodelet)
