// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <rosbag/bag.h>

#include <functional>
#include <string>

#include "profile_binder.h"

namespace pose_frame_binder {

struct BagTopics {
  std::string runs = "/scan_cell/runs";
  std::string events = "/laser_trigger/events";
  std::string profiles = "/camera/profiles";
  std::string poses = "/tf";
};

/// @throw scan_cell_common::FileError if the bag cannot be opened
void open(rosbag::Bag& bag, const std::string& path, rosbag::bagmode::BagMode mode);

/// Feeds the whole bag to the binder as one scan.
/// @param after_each called after each message
/// @throw scan_cell_common::FileError if the bag is damaged
void feed(const rosbag::Bag& bag, const BagTopics& topics, ProfileBinder& scan,
          const std::function<void()>& after_each);

}  // namespace pose_frame_binder
