// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "bag_scan.h"

#include <rosbag/view.h>

#include "scan_cell_common/ros/bag_errors.h"

namespace pose_frame_binder {

using scan_cell_common::name_bag_in_errors;

void open(rosbag::Bag& bag, const std::string& path, rosbag::bagmode::BagMode mode) {
  name_bag_in_errors(path, [&] { bag.open(path, mode); });
}

void feed(const rosbag::Bag& bag, const BagTopics& topics, ProfileBinder& scan,
          const std::function<void()>& after_each) {
  name_bag_in_errors(bag.getFileName(), [&] {
    rosbag::View view(
        bag, rosbag::TopicQuery({topics.runs, topics.events, topics.profiles, topics.poses}));
    for (const rosbag::MessageInstance& message : view) {
      if (const auto run = message.instantiate<scan_cell_msgs::ScanRun>()) {
        scan.start_run(*run);
      } else if (const auto event = message.instantiate<scan_cell_msgs::TriggerEvent>()) {
        scan.add(*event);
      } else if (const auto profile = message.instantiate<scan_cell_msgs::PeakProfile>()) {
        scan.add(profile);
      } else if (const auto poses = message.instantiate<tf2_msgs::TFMessage>()) {
        scan.add(*poses);
      }
      after_each();
    }
  });
  scan.binder().end();
  after_each();
}

}  // namespace pose_frame_binder
