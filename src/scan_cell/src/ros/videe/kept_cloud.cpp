// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/kept_cloud.h"

#include <ros/network.h>
#include <ros/service_manager.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/cloud_messages.h"

namespace scan_cell {
namespace {

using scan_cell_common::Refused;

std::string machine_of(const std::string& node) {
  std::string host;
  std::uint32_t port = 0;
  const auto services = ros::ServiceManager::instance();
  if (services->lookupService(node + "/finish", host, port)) return host;
  throw Refused(node, "its machine is not known", "is the node still running?");
}

}  // namespace

KeptCloud keep_cloud(const scan_cell_msgs::ScanResult& scan, const std::string& folder,
                     const std::string& triangulation) {
  if (!scan.cloud_file.empty()) return {scan.cloud_file, machine_of(triangulation)};
  if (scan.cloud.width == 0) {
    throw Refused("scan '" + scan.scan_id + "'", "no point was captured",
                  scan.message.empty() ? "stop it later" : scan.message);
  }
  const std::string file = folder + "/" + scan.scan_id + ".ply";
  scan_cell_common::save_cloud(file, scan_cell_common::view_of(scan.cloud));
  return {file, ros::network::getHost()};
}

}  // namespace scan_cell
