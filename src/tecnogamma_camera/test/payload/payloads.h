// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tecnogamma_camera/image_view.h"

/// Frames as smart cameras send them, byte by byte.
namespace payloads {

/// Little-endian.
inline void append(std::string& bytes, std::uint64_t number, int size) {
  for (int i = 0; i < size; ++i)
    bytes += static_cast<char>(number >> (8 * i) & 0xFF);
}

/// The thesis' TCamFrameInfo and the memory after it.
struct Relief {
  std::uint32_t time = 0x12345678;
  std::uint16_t counter = 0xABCD;
  int first_kernel = 2;
  int kernels = 3;
  int first_row = 100;
  int last_row = 103;
  int decimation = 0;
  std::uint32_t packets_lost = 0;
  std::string padding = "......";  // before the payload
  std::string payload;

  std::string bytes() const {
    std::string bytes;
    append(bytes, time, 4);
    append(bytes, counter, 2);
    append(bytes, static_cast<std::uint64_t>(first_kernel), 1);
    append(bytes, static_cast<std::uint64_t>(kernels), 1);
    append(bytes, static_cast<std::uint64_t>(first_row), 2);
    append(bytes, static_cast<std::uint64_t>(last_row), 2);
    append(bytes, static_cast<std::uint64_t>(decimation), 1);
    bytes += std::string(3, '\x7F');  // the compiler's gap
    append(bytes, 0, 4);              // end of frame
    append(bytes, packets_lost, 4);
    append(bytes, padding.size(), 4);
    append(bytes, payload.size(), 4);
    return bytes + padding + payload;
  }

  Relief& spot(int start, int width) {
    append(payload, static_cast<std::uint64_t>(start), 2);
    append(payload, static_cast<std::uint64_t>(width), 2);
    return *this;
  }
  Relief& center(int start, int width, double column) {
    spot(start, width);
    append(payload, static_cast<std::uint64_t>(column * 65536), 4);
    return *this;
  }
};

/// A 3Donly frame of a Photonfocus 3D03, one block of five rows a combined frame.
class Photonfocus {
 public:
  Photonfocus(int columns, int blocks) : columns_(columns) {
    bytes.assign(static_cast<std::size_t>(columns) * 5 * blocks, '\0');
  }

  /// The four bytes of a column, as the manual lists them.
  void set(int block, int column, int row0, int row1, int row2, int row3) {
    const int values[] = {row0, row1, row2, row3};
    for (int i = 0; i < 4; ++i)
      at(block, 1 + i, column) = static_cast<char>(at(block, 1 + i, column) | values[i]);
  }

  /// `count` nibbles of the status word from bit `first`.
  void status(int block, int first, int count, std::uint64_t value) {
    for (int i = 0; i < count; ++i) {
      char& byte = at(block, 4, first / 4 + i);
      byte = static_cast<char>(byte | static_cast<char>(value >> (4 * i) & 0xF));
    }
  }
  void number(int block, std::uint32_t counter, std::uint32_t time) {
    status(block, 0, 6, counter);
    status(block, 32, 8, time);
  }
  void fill(int block) {
    for (int row = 0; row < 5; ++row) {
      at(block, row, 0) = '\xBB';
      at(block, row, 1) = '\x44';
    }
  }

  std::string bytes;

 private:
  char& at(int block, int row, int column) {
    return bytes[static_cast<std::size_t>((5 * block + row) * columns_ + column)];
  }
  int columns_;
};

/// Bytes as a camera hands them out. They must outlive it.
inline tecnogamma_camera::ImageView8 view(const std::string& bytes, int columns = 0) {
  tecnogamma_camera::ImageView8 image;
  image.pixels = reinterpret_cast<const std::uint8_t*>(bytes.data());
  image.columns = columns > 0 ? columns : static_cast<int>(bytes.size());
  image.rows = image.columns > 0 ? static_cast<int>(bytes.size()) / image.columns : 0;
  image.stride = image.columns;
  return image;
}

}  // namespace payloads
