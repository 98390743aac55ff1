// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tecnogamma_camera {

/// How grey values are packed into bytes.
enum class Packing {
  kBytes,    //!< one or two bytes a pixel, the lower first
  kInPairs,  //!< GigE Vision's: two pixels in three bytes, their high bits in the first and third
  kInBits    //!< PFNC's "p": a row of bits, the lowest of the first pixel first
};

/// A GenICam PixelFormat of grey values (EMVA, Pixel Format Naming Convention 2.4; GigE
/// Vision 2.0).
struct PixelFormat {
  std::string name;
  std::uint32_t code;  //!< as in a frame's header
  int bits;            //!< of a grey value
  Packing packing;
  int wire_bits;  //!< of a pixel in the frame

  /// Bytes of this many consecutive pixels.
  std::size_t bytes(std::size_t pixels) const {
    return (pixels * static_cast<std::size_t>(wire_bits) + 7) / 8;
  }

  /// Bytes of an image with `padding` bytes after every row but the last. None if such rows cannot
  /// be read: packed, or beginning within a pixel.
  std::optional<std::size_t> bytes(std::size_t columns, std::size_t rows,
                                   std::size_t padding) const;
};

/// Mono8, Mono10, Mono12, Mono14, Mono16, Mono10Packed, Mono12Packed, Mono10p, Mono12p.
const std::vector<std::string>& pixel_format_names();

/// @throw scan_cell_common::InvalidParameter if there is no format of that name
const PixelFormat& pixel_format(const std::string& name);

/// Unpacks the grey values of a packed format.
/// @param bytes format.bytes(pixels.size()) of them
void unpack(const PixelFormat& format, const std::uint8_t* bytes,
            std::vector<std::uint16_t>& pixels);

}  // namespace tecnogamma_camera
