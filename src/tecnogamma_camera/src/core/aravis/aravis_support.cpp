// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "aravis/aravis_support.h"

#include "scan_cell_common/errors/errors.h"
#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

void throw_aravis_error(const std::string& thing, GError* error) {
  const std::string message = error->message;
  const bool of_device = error->domain == ARV_DEVICE_ERROR;
  const int code = error->code;
  g_error_free(error);
  if (of_device && code == ARV_DEVICE_ERROR_FEATURE_NOT_FOUND) {
    throw MissingFeature(thing, "the camera has no such feature: " + message,
                         "unset the parameter, or use a camera that has it");
  }
  if (of_device &&
      (code == ARV_DEVICE_ERROR_NOT_FOUND || code == ARV_DEVICE_ERROR_TIMEOUT ||
       code == ARV_DEVICE_ERROR_NOT_CONNECTED || code == ARV_DEVICE_ERROR_TRANSFER_ERROR)) {
    throw scan_cell_common::ConnectionError(thing, message, "check its cable, power and address");
  }
  if (of_device && (code == ARV_DEVICE_ERROR_NOT_CONTROLLER ||
                    code == ARV_DEVICE_ERROR_PROTOCOL_ERROR_ACCESS_DENIED)) {
    throw scan_cell_common::ConnectionError(thing, message,
                                            "end the other program that holds the camera");
  }
  throw scan_cell_common::InvalidParameter(thing, message, "give a value that the camera allows");
}

bool has_feature(ArvCamera* camera, const char* feature) {
  return aravis(feature,
                [&](GError** e) { return arv_camera_is_feature_available(camera, feature, e); });
}

void require_feature(ArvCamera* camera, const char* feature) {
  if (has_feature(camera, feature)) return;
  throw MissingFeature("camera feature", feature,
                       "the camera does not have it: unset the parameter, or use another camera");
}

}  // namespace tecnogamma_camera
