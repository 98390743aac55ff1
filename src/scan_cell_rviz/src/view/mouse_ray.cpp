// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/mouse_ray.h"

#include <OgreCamera.h>
#include <OgreRay.h>
#include <OgreViewport.h>

namespace scan_cell_rviz {

Ray ray_under(const rviz::ViewportMouseEvent& event, const CloudFrame& frame) {
  constexpr float kReach = 4;  // [pixels] chosen
  const Ogre::Camera* const camera = event.viewport->getCamera();
  const auto width = static_cast<float>(event.viewport->getActualWidth());
  const auto height = static_cast<float>(event.viewport->getActualHeight());
  const auto at = [&](float right) {
    return camera->getCameraToViewportRay((static_cast<float>(event.x) + right) / width,
                                          static_cast<float>(event.y) / height);
  };
  const Ogre::Ray middle = at(0), side = at(kReach);
  Ray ray;
  ray.origin = frame.to_cloud(middle.getOrigin());
  ray.direction = frame.turned_to_cloud(middle.getDirection()).normalized();
  ray.radius = (side.getOrigin() - middle.getOrigin()).length();
  ray.widening = (side.getDirection() - middle.getDirection()).length();
  return ray;
}

}  // namespace scan_cell_rviz
