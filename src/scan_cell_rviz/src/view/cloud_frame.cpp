// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/cloud_frame.h"

#include <rviz/frame_manager.h>

namespace scan_cell_rviz {
namespace {

Eigen::Vector3d from_ogre(const Ogre::Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}

}  // namespace

Eigen::Vector3d CloudFrame::to_cloud(const Ogre::Vector3& place) const {
  return from_ogre(orientation.Inverse() * (place - position));
}

Eigen::Vector3d CloudFrame::turned_to_cloud(const Ogre::Vector3& way) const {
  return from_ogre(orientation.Inverse() * way);
}

std::optional<CloudFrame> frame_in_view(rviz::DisplayContext& context, const std::string& frame) {
  CloudFrame found;
  if (!context.getFrameManager()->getTransform(frame, ros::Time(), found.position,
                                               found.orientation))
    return std::nullopt;
  return found;
}

}  // namespace scan_cell_rviz
