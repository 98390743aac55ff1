// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "services/grab_image.h"

#include <ros/topic.h>
#include <scan_cell_msgs/SetAcquisition.h>

#include <memory>

#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/ros/service_answer.h"

namespace scan_cell {

using scan_cell_common::ConnectionError;
using scan_cell_msgs::SetAcquisition;

GrabImage::GrabImage(ros::NodeHandle node, const Parameters& parameters, CellInUse& cell)
    : node_(node),
      parameters_(parameters),
      cell_(cell),
      server_(node.advertiseService("grab_image", &GrabImage::serve, this)) {}

bool GrabImage::serve(scan_cell_msgs::GrabImage::Request&,
                      scan_cell_msgs::GrabImage::Response& response) {
  return scan_cell_common::answer(response, [&] {
    cell_.take("image", "one");
    const std::shared_ptr<void> release(nullptr, [this](void*) { cell_.release(); });
    response.image = grab();
  });
}

sensor_msgs::Image GrabImage::grab() {
  set_acquisition(SetAcquisition::Request::LIVE_ONLY);
  const auto image = ros::topic::waitForMessage<sensor_msgs::Image>(
      parameters_.camera + "/image_raw", node_, ros::Duration(parameters_.call_timeout));
  set_acquisition(SetAcquisition::Request::STOP);
  if (!image) throw ConnectionError("camera", "no image came", "check the camera's cable");
  return *image;
}

void GrabImage::set_acquisition(std::uint8_t mode) const {
  SetAcquisition::Request request;
  request.mode = mode;
  request.trigger = SetAcquisition::Request::FREE_RUN;
  call<SetAcquisition>(parameters_.camera + "/set_acquisition", request, parameters_.call_timeout);
}

}  // namespace scan_cell
