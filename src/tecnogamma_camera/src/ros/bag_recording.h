// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "tecnogamma_camera/recording.h"

namespace tecnogamma_camera {

/// Opens the images of 8 or 16 bit grey in a bag, with their stamps. Number and clock of a frame
/// come from the profile of the same stamp, on the topic `profiles` beside that of the images; an
/// image without a profile has no number. If the bag has no such profiles, the images are numbered
/// from 1. Their place on the sensor comes from `camera_info` beside them.
/// @param topic of the images; empty: the only one in the bag
/// @throw scan_cell_common::FileError if the bag cannot be read
/// @throw scan_cell_common::UnusableInput if it has no such topic, several, or the region changes
std::unique_ptr<Recording> open_bag_recording(const std::string& path, const std::string& topic);

}  // namespace tecnogamma_camera
