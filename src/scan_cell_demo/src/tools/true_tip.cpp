// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tools/true_tip.h"

#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/ros/conversions.h"

namespace scan_cell_demo {

using scan_cell_common::YamlEntry;

TrueTip::TrueTip(ros::NodeHandle node, const std::string& simulator, const std::string& cell)
    : base_in_world_(YamlEntry::load(cell)["base_link_in_world"].pose()),
      tip_in_flange_(YamlEntry::load(cell)["tool_tip_in_tool0"].pose().translation()) {
  subscriber_ = node.subscribe(simulator + "/true_flange", 1000, &TrueTip::on_flange, this);
}

void TrueTip::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  way_.clear();
}

std::vector<Eigen::Vector3d> TrueTip::way() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return way_;
}

void TrueTip::on_flange(const geometry_msgs::PoseStamped& flange) {
  const Eigen::Vector3d tip =
      base_in_world_ * scan_cell_common::from_ros(flange.pose) * tip_in_flange_;
  const std::lock_guard<std::mutex> lock(mutex_);
  way_.push_back(tip);
}

}  // namespace scan_cell_demo
