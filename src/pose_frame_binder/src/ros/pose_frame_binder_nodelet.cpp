// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pluginlib/class_list_macros.hpp>

#include "binder_services.h"
#include "scan_cell_common/ros/services.h"

namespace pose_frame_binder {

class BinderNodelet : public scan_cell_common::ServicesNodelet<BinderServices, Parameters> {};

}  // namespace pose_frame_binder

PLUGINLIB_EXPORT_CLASS(pose_frame_binder::BinderNodelet, nodelet::Nodelet)
