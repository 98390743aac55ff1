// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nodelet/loader.h>
#include <ros/ros.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/testing/child_process.h"

namespace pose_frame_binder {

constexpr double kPatience = 30;  //!< [s] chosen

/// Starts this process as a ROS node, under the master of the bench.
void join_master(const std::string& name);

/// @throw scan_cell_common::Refused after half a minute
template <class Condition>
void wait_until(const std::string& what, const Condition& met) {
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPatience);
  while (!met()) {
    if (ros::WallTime::now() > deadline)
      throw scan_cell_common::Refused(what, "not there after 30 s", "see the nodes' messages");
    ros::WallDuration(0.01).sleep();
  }
}

/// @throw scan_cell_common::Refused if there is no answer
template <class Service>
typename Service::Response call(const std::string& name, typename Service::Request request) {
  typename Service::Response response;
  if (!ros::service::waitForService(name, ros::Duration(kPatience)) ||
      !ros::service::call(name, request, response)) {
    throw scan_cell_common::Refused("service " + name, "no answer", "see the nodes' messages");
  }
  return response;
}

/// Binder and triangulation with a scan in progress, in this process or each in its own.
class StartedChain {
 public:
  /// @param program path of the bench; the nodes are in the same folder
  /// @throw scan_cell_common::Refused if one does not start
  StartedChain(const std::string& program, bool nodelets);

  bool here() const { return loader_ != nullptr; }  ///< in this process
  scan_cell_common::Usage usage() const;

 private:
  void load_nodelets();
  void start_nodes(const std::filesystem::path& folder);

  std::unique_ptr<nodelet::Loader> loader_;
  std::vector<std::unique_ptr<scan_cell_common::ChildProcess>> nodes_;
};

}  // namespace pose_frame_binder
