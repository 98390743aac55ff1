// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OgreQuaternion.h>
#include <OgreVector3.h>
#include <rviz/display_context.h>

#include <Eigen/Core>
#include <optional>
#include <string>

namespace scan_cell_rviz {

/// Pose of the cloud's frame in the view's frame.
struct CloudFrame {
  Ogre::Vector3 position = Ogre::Vector3::ZERO;  //!< [m]
  Ogre::Quaternion orientation = Ogre::Quaternion::IDENTITY;

  Eigen::Vector3d to_cloud(const Ogre::Vector3& place) const;       //!< [m]
  Eigen::Vector3d turned_to_cloud(const Ogre::Vector3& way) const;  //!< of a direction
};

/// @return none if rviz does not know the frame
std::optional<CloudFrame> frame_in_view(rviz::DisplayContext& context, const std::string& frame);

inline Ogre::Vector3 to_ogre(const Eigen::Vector3d& place) {
  return Ogre::Vector3(static_cast<float>(place.x()), static_cast<float>(place.y()),
                       static_cast<float>(place.z()));
}

}  // namespace scan_cell_rviz
