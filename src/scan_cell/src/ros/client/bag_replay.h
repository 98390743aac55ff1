// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <rosbag/bag.h>
#include <scan_cell_msgs/ScanRun.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace scan_cell {

/// A recorded scan.
struct RecordedScan {
  std::string scan_id;
  ros::Time start;
  ros::Time end;
  bool whole = false;  //!< whether it did not end early
  /// The run of each arming, in order; empty if the bag does not hold them: then each arming is a
  /// pass.
  std::vector<scan_cell_msgs::ScanRun> runs;
};

/// Plays one scan of a bag to the binder, at any speed and without losing a message.
class BagReplay {
 public:
  /// Topics in the bag, also used for publishing.
  struct Topics {
    std::string state = "/scan_cell/state";
    std::string runs = "/scan_cell/runs";
    std::string events = "/laser_trigger/events";
    std::string profiles = "/camera/profiles";
    std::string poses = "/tf";
  };

  /// @throw FileError if the bag cannot be read
  /// @throw UnusableInput if it holds no whole scan, no pulses, no profiles or no poses
  /// @param scan_id the scan, whole or not; empty: the last whole one
  BagReplay(const std::string& path, const std::string& scan_id, const Topics& topics);

  const RecordedScan& scan() const { return scan_; }
  std::uint64_t pulses() const { return pulses_; }  //!< of the scan

  /// Publishes the scan's messages in recorded order.
  /// @param speed factor over real time
  /// @param timeout [s] to wait until all subscribers are connected
  /// @throw ConnectionError if they are not, or nobody subscribes
  void play(ros::NodeHandle node, double speed, double timeout,
            const std::function<void(double)>& progress);

 private:
  void choose(const std::string& scan_id);
  std::vector<RecordedScan> find_scans() const;
  void check_contents();

  std::string path_;
  Topics topics_;
  rosbag::Bag bag_;
  RecordedScan scan_;
  std::uint64_t pulses_ = 0;
};

}  // namespace scan_cell
