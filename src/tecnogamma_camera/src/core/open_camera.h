// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "aravis/aravis_camera.h"
#include "tecnogamma_camera/photonfocus_3d03.h"
#include "tecnogamma_camera/recording.h"
#include "tecnogamma_camera/tecnogamma_relief.h"

namespace tecnogamma_camera {

/// What the frames of a camera hold, and how to read it.
struct PayloadOptions {
  std::string format = "image";         //!< one of payload_names()
  TecnogammaSettings tecnogamma;        //!< of the format tecnogamma_relief
  Photonfocus3D03Settings photonfocus;  //!< of the format photonfocus_3d03
};

/// "image", "tecnogamma_relief", "photonfocus_3d03".
const std::vector<std::string>& payload_names();

/// What open_camera() needs besides the camera's name.
struct CameraOptions {
  AravisOptions stream;      //!< of a GenICam camera
  PlaybackOptions playback;  //!< of a recording
  PayloadOptions payload;    //!< what the frames hold
};

/// Opens a camera by its name: "folder:PATH" and the kinds in `kinds` are recordings, anything else
/// is a GenICam camera (open_aravis_camera).
/// @throw scan_cell_common::Error as open_aravis_camera() and the recording's opener;
/// InvalidParameter if there is no such payload or a setting is out of range
std::unique_ptr<Camera> open_camera(const std::string& name, const CameraOptions& options,
                                    const RecordingKinds& kinds = {});

}  // namespace tecnogamma_camera
