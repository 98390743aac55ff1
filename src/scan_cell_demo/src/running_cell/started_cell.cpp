// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "running_cell/started_cell.h"

#include <filesystem>

#include "running_cell/nodes.h"

namespace scan_cell_demo {
namespace {

std::vector<std::string> command(const std::vector<std::string>& launch,
                                 const std::string& folder) {
  const std::string port = std::to_string(scan_cell_common::free_port());
  setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
  setenv("ROS_IP", "127.0.0.1", 1);
  if (!folder.empty()) {
    const std::filesystem::path home = std::filesystem::absolute(folder) / "ros";
    std::filesystem::create_directories(home);
    setenv("ROS_HOME", home.c_str(), 1);
  }
  std::vector<std::string> words = {"roslaunch", "-p", port};
  words.insert(words.end(), launch.begin(), launch.end());
  return words;
}

ros::AsyncSpinner joined(const std::string& name) {
  ros::M_string no_remappings;
  ros::init(no_remappings, name, ros::init_options::NoRosout);
  wait_until("ROS master", [] { return ros::master::check(); });
  ros::start();
  return ros::AsyncSpinner(2);
}

}  // namespace

StartedCell::StartedCell(const std::string& name, const std::vector<std::string>& launch,
                         const std::string& folder)
    : launched_(command(launch, folder), true), spinner_(joined(name)) {
  spinner_.start();
}

}  // namespace scan_cell_demo
