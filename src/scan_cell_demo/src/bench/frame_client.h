// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scan_cell_common/pose/timed_pose.h"
#include "tecnogamma_camera/image_view.h"

typedef struct _ArvCamera ArvCamera;  // NOLINT: as declared by Aravis
typedef struct _ArvStream ArvStream;  // NOLINT

namespace scan_cell_demo {

/// A received frame.
struct Received {
  std::uint64_t block = 0;                  //!< the camera's counter
  scan_cell_common::Nanoseconds time = 0;   //!< of the exposure, on the camera's clock
  std::string fault;                        //!< why it is unusable; empty: it is usable
  int x = 0, y = 0, width = 0, height = 0;  //!< [px] its region on the sensor
  std::vector<std::uint8_t> pixels;         //!< row by row

  tecnogamma_camera::ImageView8 image() const {
    return {pixels.data(), width, height, width, x, y};
  }
};

/// A client of the camera at an address, with external trigger.
class FrameClient {
 public:
  /// @throw scan_cell_common::ConnectionError if the camera does not answer or start
  explicit FrameClient(const std::string& address);
  ~FrameClient();
  FrameClient(const FrameClient&) = delete;
  FrameClient& operator=(const FrameClient&) = delete;

  /// Pulses a camera that was just started, and may miss pulses, until a frame comes; then waits
  /// until no more come.
  void wait_until_it_takes(const std::function<void()>& begin_pulses,
                           const std::function<void()>& end_pulses);

  /// The next frame; none if it does not come within some milliseconds.
  std::optional<Received> next();

 private:
  ArvCamera* camera_ = nullptr;
  ArvStream* stream_ = nullptr;
};

}  // namespace scan_cell_demo
