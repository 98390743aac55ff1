// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "frame/pixel_format.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"

namespace tecnogamma_camera {
namespace {

const std::vector<PixelFormat>& pixel_formats() {
  static const std::vector<PixelFormat> formats = {
      {"Mono8", 0x01080001, 8, Packing::kBytes, 8},
      {"Mono10", 0x01100003, 10, Packing::kBytes, 16},
      {"Mono12", 0x01100005, 12, Packing::kBytes, 16},
      {"Mono14", 0x01100025, 14, Packing::kBytes, 16},
      {"Mono16", 0x01100007, 16, Packing::kBytes, 16},
      {"Mono10Packed", 0x010C0004, 10, Packing::kInPairs, 12},
      {"Mono12Packed", 0x010C0006, 12, Packing::kInPairs, 12},
      {"Mono10p", 0x010A0046, 10, Packing::kInBits, 10},
      {"Mono12p", 0x010C0047, 12, Packing::kInBits, 12}};
  return formats;
}

/// The first pixel's low bits are in the middle byte's lower half, the second's in its upper half.
void unpack_pairs(int bits, const std::uint8_t* bytes, std::vector<std::uint16_t>& pixels) {
  const int low_bits = bits - 8;
  const int low_mask = (1 << low_bits) - 1;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::uint8_t* const pair = bytes + i / 2 * 3;
    const int high = i % 2 == 0 ? pair[0] : pair[2];
    const int low = (i % 2 == 0 ? pair[1] : pair[1] >> 4) & low_mask;
    pixels[i] = static_cast<std::uint16_t>(high << low_bits | low);
  }
}

/// A pixel of 10 or 12 bits never spans more than two bytes.
void unpack_bits(int bits, const std::uint8_t* bytes, std::vector<std::uint16_t>& pixels) {
  const int mask = (1 << bits) - 1;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t bit = i * static_cast<std::size_t>(bits);
    const std::uint8_t* const first = bytes + bit / 8;
    pixels[i] = static_cast<std::uint16_t>((first[0] | first[1] << 8) >> bit % 8 & mask);
  }
}

}  // namespace

std::optional<std::size_t> PixelFormat::bytes(std::size_t columns, std::size_t rows,
                                              std::size_t padding) const {
  if (padding == 0 || rows < 2) return bytes(columns * rows);
  const bool whole_pixels = packing == Packing::kBytes && padding % bytes(1) == 0;
  if (!whole_pixels) return std::nullopt;
  return bytes(columns * rows) + padding * (rows - 1);
}

const std::vector<std::string>& pixel_format_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const PixelFormat& format : pixel_formats())
      result.push_back(format.name);
    return result;
  }();
  return names;
}

const PixelFormat& pixel_format(const std::string& name) {
  const auto found = std::find_if(pixel_formats().begin(), pixel_formats().end(),
                                  [&](const PixelFormat& format) { return format.name == name; });
  if (found != pixel_formats().end()) return *found;
  std::string names;
  for (const std::string& known : pixel_format_names())
    names += (names.empty() ? "" : ", ") + known;
  throw scan_cell_common::InvalidParameter("pixel_format", "'" + name + "'",
                                           "give one of " + names);
}

void unpack(const PixelFormat& format, const std::uint8_t* bytes,
            std::vector<std::uint16_t>& pixels) {
  if (format.packing == Packing::kInPairs) {
    unpack_pairs(format.bits, bytes, pixels);
  } else {
    unpack_bits(format.bits, bytes, pixels);
  }
}

}  // namespace tecnogamma_camera
