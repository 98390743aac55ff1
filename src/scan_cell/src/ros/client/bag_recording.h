// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/CellState.h>
#include <topic_tools/shape_shifter.h>

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "client/bag_replay.h"

namespace scan_cell {

/// Records what replay needs from one scan. An unfinished recording is removed.
class BagRecording {
 public:
  /// Begins once it receives all topics.
  /// @param timeout [s] to wait for the topics' nodes
  /// @throw scan_cell_common::FileError if the bag cannot be written
  /// @throw scan_cell_common::ConnectionError naming a topic that nobody publishes
  BagRecording(ros::NodeHandle node, std::string file, double timeout);
  ~BagRecording();
  BagRecording(const BagRecording&) = delete;
  BagRecording& operator=(const BagRecording&) = delete;

  /// Ends with the cell's message that the scan is over.
  /// @throw scan_cell_common::ConnectionError if that message does not arrive
  /// @throw scan_cell_common::FileError if not everything could be written to disk
  void finish(const std::string& scan_id);

 private:
  using Message = ros::MessageEvent<const topic_tools::ShapeShifter>;

  void add(const std::string& topic, const Message& message);
  void look_for_end(const scan_cell_msgs::CellState& state);

  std::string file_;
  rosbag::Bag bag_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::string ended_;                   // the scan that ended last
  std::optional<std::string> failure_;  // of the disk
  bool finished_ = false;
  std::vector<ros::Subscriber> subscribers_;  // last, since they call add()
};

}  // namespace scan_cell
