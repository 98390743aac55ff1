// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/node_handle.h>
#include <scan_cell_msgs/GrabImage.h>

#include "actions/cell_in_use.h"
#include "parameters/parameters.h"

namespace scan_cell {

/// The service ~grab_image. It occupies the cell while it takes the image, so that no scan begins
/// meanwhile.
class GrabImage {
 public:
  GrabImage(ros::NodeHandle node, const Parameters& parameters, CellInUse& cell);

 private:
  bool serve(scan_cell_msgs::GrabImage::Request& request,
             scan_cell_msgs::GrabImage::Response& response);
  sensor_msgs::Image grab();
  void set_acquisition(std::uint8_t mode) const;

  ros::NodeHandle node_;
  const Parameters parameters_;
  CellInUse& cell_;
  ros::ServiceServer server_;
};

}  // namespace scan_cell
