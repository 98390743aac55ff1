// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_scan.h"

#include <rosbag/view.h>

#include "scan_cell_common/errors.h"

namespace pose_frame_binder {

void open(rosbag::Bag& bag, const std::string& path, rosbag::bagmode::BagMode mode) {
  try {
    bag.open(path, mode);
  } catch (const rosbag::BagException& error) {
    throw scan_cell_common::FileError(path, error.what(), "check the path, or run rosbag reindex");
  }
}

void feed(const rosbag::Bag& bag, const BagTopics& topics, ProfileBinder& scan,
          const std::function<void()>& after_each) {
  rosbag::View view(bag, rosbag::TopicQuery({topics.events, topics.profiles, topics.poses}));
  for (const rosbag::MessageInstance& message : view) {
    if (const auto event = message.instantiate<scan_cell_msgs::TriggerEvent>()) {
      scan.add(*event);
    } else if (const auto profile = message.instantiate<scan_cell_msgs::PeakProfile>()) {
      scan.add(profile);
    } else if (const auto poses = message.instantiate<tf2_msgs::TFMessage>()) {
      scan.add(*poses);
    }
    after_each();
  }
  scan.binder().end();
  after_each();
}

}  // namespace pose_frame_binder
