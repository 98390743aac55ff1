// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "aravis/aravis_camera.h"
#include "aravis/aravis_support.h"

namespace tecnogamma_camera {

std::vector<CameraListing> list_aravis_cameras() {
  arv_update_device_list();
  std::vector<CameraListing> cameras;
  const unsigned count = arv_get_n_devices();
  for (unsigned i = 0; i < count; ++i) {
    cameras.push_back({to_text(arv_get_device_id(i)), to_text(arv_get_device_vendor(i)),
                       to_text(arv_get_device_model(i)), to_text(arv_get_device_serial_nbr(i)),
                       to_text(arv_get_device_address(i)), to_text(arv_get_device_protocol(i))});
  }
  return cameras;
}

std::string find_aravis_camera(const std::string& name) {
  const std::vector<CameraListing> cameras = list_aravis_cameras();
  std::string found;
  std::string all;
  int matches = 0;
  for (const CameraListing& camera : cameras) {
    all += (all.empty() ? "" : ", ") + camera.id;
    if (name.empty() || name == camera.id || name == camera.serial || name == camera.address) {
      found = camera.id;
      ++matches;
    }
  }
  if (matches == 1) return found;
  throw scan_cell_common::ConnectionError(
      "camera '" + name + "'", matches ? "several cameras match" : "no camera matches",
      cameras.empty() ? "no camera answers: check cable, power and address"
                      : "these cameras answer: " + all);
}

}  // namespace tecnogamma_camera
