// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arv.h>

#include <string>
#include <vector>

#include "frame/pixel_format.h"
#include "tecnogamma_camera/camera.h"

/// Writes the settings of Camera::configure() to a GenICam camera. All throw as it does.
namespace tecnogamma_camera {

constexpr double kMicroseconds = 1e6;  // [us] in a second: GenICam's unit of the exposure

Region read_region(ArvCamera* arv);

/// A refused region leaves the camera with the one it had.
/// @return with width and height
Region write_region(ArvCamera* arv, const Region& wanted);

/// For a camera whose rows are not sensor rows: writes only the columns, and takes the number of
/// rows from the camera (HeightInterface, if it has that).
/// @return the region it sends
Region write_payload_region(ArvCamera* arv, const Region& wanted);

/// @throw MissingFeature naming the pixel format if the camera does not have it
const PixelFormat& write_pixel_format(ArvCamera* arv, const std::string& name);

void write_exposure(ArvCamera* arv, double exposure);
void write_gain(ArvCamera* arv, double gain);
void write_rate(ArvCamera* arv, double rate);
void write_trigger(ArvCamera* arv, Trigger trigger, const std::string& source);

/// The words that an enumeration of the camera offers; none if the camera lacks the enumeration.
std::vector<std::string> words_of(ArvCamera* arv, const char* feature);

/// Drives outputs of the camera during its lifetime: reads each line's settings, makes it an output
/// of `source`, and restores everything at the end, including the selector. Other lines are not
/// changed.
class StrobeOutputs {
 public:
  /// @param lines their names, separated by commas
  /// @throw MissingFeature if the camera has no lines to set; InvalidParameter if not one of these
  StrobeOutputs(ArvCamera* arv, const std::string& lines, const std::string& source);
  ~StrobeOutputs() { restore(); }
  StrobeOutputs(const StrobeOutputs&) = delete;
  StrobeOutputs& operator=(const StrobeOutputs&) = delete;

  /// Restores nothing: the camera is lost.
  void forget() { changed_.clear(); }

 private:
  void change(const char* feature, const std::string& value);
  void restore();

  struct Change {
    const char* feature;
    std::string before;
  };

  ArvCamera* arv_;
  std::vector<Change> changed_;
};

}  // namespace tecnogamma_camera
