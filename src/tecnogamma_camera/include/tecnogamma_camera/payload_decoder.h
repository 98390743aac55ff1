// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tecnogamma_camera/camera.h"

namespace tecnogamma_camera {

/// One frame from a smart camera's payload.
struct DecodedFrame {
  std::uint64_t counter = kNoFrameNumber;  //!< raw, as the camera counts
  std::optional<std::uint32_t> ticks;      //!< of the camera's clock at the exposure, raw
  std::uint32_t packets_lost = 0;          //!< as the camera reports; then neither peaks nor pixels
  std::uint32_t impossible_peaks = 0;      //!< left out of `peaks`
  bool has_peaks = false;                  //!< false: an image
  PeakProfile peaks;                       //!< if has_peaks
  ImageView8 image;                  //!< its region; with pixels if the payload holds an image
  std::vector<std::uint8_t> pixels;  //!< of `image`, if they are not in the payload
};

/// Returns the value of a camera feature, if the camera has it.
using FeatureReader = std::function<std::optional<std::int64_t>(const std::string&)>;

/// Reads what a smart camera sends instead of an image.
class PayloadDecoder {
 public:
  virtual ~PayloadDecoder() = default;

  /// Reads the payload's settings from the camera. Call it at each start, before decode().
  /// @throw scan_cell_common::InvalidParameter naming a setting the camera does not report
  /// @throw scan_cell_common::UnusableInput if the camera sends data that cannot be read
  virtual void adapt(const FeatureReader& feature) = 0;

  /// Corrects the sensor and the counter in a description.
  virtual void describe(CameraDescription& camera) const = 0;

  /// [ns] of a tick of the camera's clock; 0: not known
  virtual double tick() const = 0;

  /// Decodes a payload: its bytes as an image of 8 bits a pixel. Any bytes are safe.
  /// @param frames grows where needed and is never made smaller: it keeps its memory
  /// @return how many of `frames`, from the first, were written
  /// @throw scan_cell_common::UnusableInput if the payload is not whole or makes no sense
  virtual std::size_t decode(const ImageView8& payload,
                             std::vector<DecodedFrame>& frames) const = 0;
};

}  // namespace tecnogamma_camera
