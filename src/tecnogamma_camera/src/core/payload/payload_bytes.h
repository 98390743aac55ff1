// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "tecnogamma_camera/payload_decoder.h"

namespace tecnogamma_camera {

/// Little-endian.
inline std::uint16_t read_16(const std::uint8_t* bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8);
}
inline std::uint32_t read_32(const std::uint8_t* bytes) {
  return read_16(bytes) | static_cast<std::uint32_t>(read_16(bytes + 2)) << 16;
}

/// The bytes of a payload one after the other, copied only where its rows are padded.
class PayloadBytes {
 public:
  explicit PayloadBytes(const ImageView8& payload)
      : data_(payload.pixels),
        size_(static_cast<std::size_t>(payload.columns) * static_cast<std::size_t>(payload.rows)) {
    if (payload.rows <= 1 || payload.stride == payload.columns) return;
    copy_.reserve(size_);
    for (int row = 0; row < payload.rows; ++row)
      copy_.insert(copy_.end(), payload.row(row), payload.row(row) + payload.columns);
    data_ = copy_.data();
  }

  const std::uint8_t* data() const { return data_; }
  std::size_t size() const { return size_; }

 private:
  std::vector<std::uint8_t> copy_;
  const std::uint8_t* data_;
  std::size_t size_;
};

/// frames[index], cleared; its arrays keep their memory.
inline DecodedFrame& begin_frame(std::vector<DecodedFrame>& frames, std::size_t index) {
  if (index == frames.size()) frames.emplace_back();
  DecodedFrame& frame = frames[index];
  frame.counter = kNoFrameNumber;
  frame.ticks.reset();
  frame.packets_lost = 0;
  frame.impossible_peaks = 0;
  frame.has_peaks = false;
  frame.image = {};
  frame.pixels.clear();
  return frame;
}

}  // namespace tecnogamma_camera
