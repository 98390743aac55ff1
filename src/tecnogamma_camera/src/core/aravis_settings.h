// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arv.h>

#include <string>

#include "tecnogamma_camera/camera.h"
#include "tecnogamma_camera/pixel_format.h"

/// Writes what Camera::configure() takes to a GenICam camera. All throw as it does.
namespace tecnogamma_camera {

constexpr double kMicroseconds = 1e6;  // in a second: GenICam's unit of the exposure

Region read_region(ArvCamera* arv);

/// A region that is refused leaves the camera as it was.
/// @return with width and height
Region write_region(ArvCamera* arv, const Region& wanted);

/// @throw MissingFeature naming the pixel format if the camera does not have it
const PixelFormat& write_pixel_format(ArvCamera* arv, const std::string& name);

void write_exposure(ArvCamera* arv, double exposure);
void write_gain(ArvCamera* arv, double gain);
void write_rate(ArvCamera* arv, double rate);
void write_trigger(ArvCamera* arv, Trigger trigger, const std::string& source);

}  // namespace tecnogamma_camera
