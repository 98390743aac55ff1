// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/handle_server.h"

#include <ros/init.h>

namespace scan_cell_rviz {

void HandleServer::clear() {
  if (server_) server_->clear();
}

void HandleServer::insert(const visualization_msgs::InteractiveMarker& marker, const Taken& taken) {
  if (!server_) {
    if (ros::isShuttingDown()) return;
    server_ = std::make_unique<interactive_markers::InteractiveMarkerServer>(topic_);
  }
  server_->insert(marker, taken);
}

void HandleServer::apply() {
  if (server_) server_->applyChanges();
}

}  // namespace scan_cell_rviz
