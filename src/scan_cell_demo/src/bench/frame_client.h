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

typedef struct _ArvCamera ArvCamera;  // NOLINT: as Aravis declares them
typedef struct _ArvStream ArvStream;  // NOLINT

namespace scan_cell_demo {

/// A frame as it came.
struct Received {
  std::uint64_t block = 0;                  //!< the camera's counter
  scan_cell_common::Nanoseconds time = 0;   //!< of the exposure, by the camera's clock
  std::string fault;                        //!< why it cannot be used; empty where it can
  int x = 0, y = 0, width = 0, height = 0;  //!< [px] its place on the sensor
  std::vector<std::uint8_t> pixels;         //!< row by row

  tecnogamma_camera::ImageView8 image() const {
    return {pixels.data(), width, height, width, x, y};
  }
};

/// The camera at an address, on external trigger.
class FrameClient {
 public:
  /// @throw scan_cell_common::ConnectionError if it does not answer, or does not start
  explicit FrameClient(const std::string& address);
  ~FrameClient();
  FrameClient(const FrameClient&) = delete;
  FrameClient& operator=(const FrameClient&) = delete;

  /// A camera that was just started may miss pulses: pulses it until a frame comes and no more.
  void wait_until_it_takes(const std::function<void()>& begin_pulses,
                           const std::function<void()>& end_pulses);

  /// The next frame, or none within some milliseconds.
  std::optional<Received> next();

 private:
  ArvCamera* camera_ = nullptr;
  ArvStream* stream_ = nullptr;
};

}  // namespace scan_cell_demo
