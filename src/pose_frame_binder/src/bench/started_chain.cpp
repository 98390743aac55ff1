// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "started_chain.h"

#include <fmt/format.h>
#include <scan_cell_msgs/StartScan.h>
#include <unistd.h>

#include "scan_cell_common/scanner/scanner_model.h"

namespace pose_frame_binder {

using scan_cell_common::ChildProcess;
using scan_cell_common::Usage;
using scan_cell_common::usage_of;

namespace {

scan_cell_common::ScannerModel scanner() {
  scan_cell_common::ScannerModel model;
  model.camera.width = 1696;
  model.camera.height = 1710;
  model.camera.fx = 801.3;
  model.camera.fy = 800.6;
  model.camera.cx = 851.2;
  model.camera.cy = 852.7;
  model.camera.distortion << -0.081, 0.052, 0.0006, -0.0004, 0.0;
  for (const double side : {1, -1}) {
    scan_cell_common::LaserPlane laser;
    laser.origin << -0.25 * side, 0, 0.012;
    laser.normal = Eigen::Vector3d(0.89 * side, -0.001, -0.456).normalized();
    laser.distance = laser.normal.dot(laser.origin);
    model.lasers.push_back(laser);
  }
  return model;
}

}  // namespace

void join_master(const std::string& name) {
  ros::M_string no_remappings;
  ros::init(no_remappings, name, ros::init_options::NoRosout);
  if (ros::console::set_logger_level(ROSCONSOLE_ROOT_LOGGER_NAME, ros::console::levels::Warn))
    ros::console::notifyLoggerLevelsChanged();
  wait_until("ROS master", [] { return ros::master::check(); });
}

StartedChain::StartedChain(const std::string& program, bool nodelets) {
  const std::string file =
      std::filesystem::temp_directory_path() / fmt::format("chain_{}.yaml", getpid());
  scan_cell_common::save_scanner_model(file, scanner());
  ros::param::set("/binder/fixed_frame", "base_link");
  ros::param::set("/triangulation/scanner", file);
  if (nodelets) {
    load_nodelets();
  } else {
    start_nodes(std::filesystem::path(program).parent_path());
  }
  scan_cell_msgs::StartScan::Request scan;
  scan.scan_id = "bench";
  for (const char* name : {"/binder/start", "/triangulation/start"}) {
    const auto answer = call<scan_cell_msgs::StartScan>(name, scan);
    if (!answer.success) throw scan_cell_common::Refused(name, answer.message, "see the message");
  }
  std::filesystem::remove(file);
}

Usage StartedChain::usage() const {
  Usage sum = loader_ ? usage_of(getpid()) : Usage();
  for (const auto& node : nodes_) {
    const Usage used = usage_of(node->id());
    sum.cpu += used.cpu;
    sum.memory += used.memory;
  }
  return sum;
}

void StartedChain::load_nodelets() {
  loader_ = std::make_unique<nodelet::Loader>(false);
  const bool loaded = loader_->load("/binder", "pose_frame_binder/Binder", {}, {}) &&
                      loader_->load("/triangulation", "laser_triangulation/Triangulation",
                                    {{"bound_profiles", "/binder/bound_profiles"}}, {});
  if (!loaded) throw scan_cell_common::Refused("nodelets", "not loaded", "see the errors above");
}

void StartedChain::start_nodes(const std::filesystem::path& folder) {
  nodes_.push_back(std::make_unique<ChildProcess>(
      std::vector<std::string>{folder / "pose_frame_binder_node", "__name:=binder"}, true));
  nodes_.push_back(std::make_unique<ChildProcess>(
      std::vector<std::string>{
          folder.parent_path() / "laser_triangulation/laser_triangulation_node",
          "__name:=triangulation", "bound_profiles:=/binder/bound_profiles"},
      true));
}

}  // namespace pose_frame_binder
