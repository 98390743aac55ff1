// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "frame_lookup.h"
#include "profile_binder.h"

namespace pose_frame_binder {

struct Parameters {
  Settings settings;
  Frames frames;
  LookupParameters lookup;
  double transform_timeout = 2;  //!< [s] for the static transform from fixed frame to base

  /// @throw scan_cell_common::InvalidParameter
  static Parameters load(const ros::NodeHandle& node);
};

}  // namespace pose_frame_binder
