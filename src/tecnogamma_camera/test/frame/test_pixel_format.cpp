// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "frame/pixel_format.h"
#include "scan_cell_common/errors/errors.h"

using tecnogamma_camera::pixel_format;
using tecnogamma_camera::PixelFormat;

namespace {

std::vector<std::uint16_t> unpacked(const std::string& name, const std::vector<std::uint8_t>& bytes,
                                    std::size_t pixels) {
  std::vector<std::uint16_t> result(pixels);
  unpack(pixel_format(name), bytes.data(), result);
  return result;
}

using Grey = std::vector<std::uint16_t>;

}  // namespace

TEST(PixelFormat, UnpacksGigEVisionPairsAsItsFiguresShow) {
  // GigE Vision 2.0, figures of Mono10Packed and Mono12Packed: bits 9..2 | Q1 Q0 in bits 5, 4 and
  // P1 P0 in bits 1, 0 | bits 9..2; bits 11..4 | Q3..Q0 P3..P0 | bits 11..4.
  EXPECT_EQ(unpacked("Mono10Packed", {0xFF, 0x01, 0x80}, 2), (Grey{0x3FD, 0x200}));
  EXPECT_EQ(unpacked("Mono10Packed", {0x00, 0x23, 0x01}, 2), (Grey{0x003, 0x006}));
  EXPECT_EQ(unpacked("Mono12Packed", {0xAB, 0x6C, 0x45}, 2), (Grey{0xABC, 0x456}));
}

TEST(PixelFormat, UnpacksPfncBitsLowestFirst) {
  EXPECT_EQ(unpacked("Mono12p", {0xBC, 0x6A, 0x45}, 2), (Grey{0xABC, 0x456}));
  // 0x3FF, 0, 0x3FF, 1: bits 0..9 set, 20..29 set, 30 set.
  EXPECT_EQ(unpacked("Mono10p", {0xFF, 0x03, 0xF0, 0x7F, 0x00}, 4), (Grey{0x3FF, 0, 0x3FF, 1}));
}

TEST(PixelFormat, UnpacksWhatWasPackedBitByBit) {
  std::mt19937 engine(1);
  for (const std::string name : {"Mono10p", "Mono12p"}) {
    const PixelFormat& format = pixel_format(name);
    for (std::size_t count = 1; count < 50; ++count) {
      Grey grey(count);
      std::vector<std::uint8_t> bytes(format.bytes(count));
      for (std::size_t i = 0; i < count; ++i) {
        grey[i] = static_cast<std::uint16_t>(engine() % (1U << format.bits));
        for (int bit = 0; bit < format.bits; ++bit) {
          const std::size_t place = i * static_cast<std::size_t>(format.bits) + bit;
          bytes[place / 8] =
              static_cast<std::uint8_t>(bytes[place / 8] | (grey[i] >> bit & 1) << place % 8);
        }
      }
      EXPECT_EQ(unpacked(name, bytes, count), grey) << name << " " << count;
    }
  }
}

TEST(PixelFormat, NeverReadsPastTheBytesOfItsPixels) {
  for (const std::string& name : tecnogamma_camera::pixel_format_names()) {
    const PixelFormat& format = pixel_format(name);
    if (format.packing == tecnogamma_camera::Packing::kBytes) continue;
    for (std::size_t count = 1; count < 9; ++count) {
      // A value after the last byte would show: all bits of it are set.
      std::vector<std::uint8_t> bytes(format.bytes(count) + 2, 0);
      bytes[format.bytes(count)] = bytes[format.bytes(count) + 1] = 0xFF;
      EXPECT_EQ(unpacked(name, bytes, count), Grey(count, 0)) << name << " " << count;
    }
  }
}

TEST(PixelFormat, NamesTheFormatsWhereAnotherIsAskedFor) {
  try {
    pixel_format("BayerRG8");
    FAIL();
  } catch (const scan_cell_common::InvalidParameter& error) {
    EXPECT_NE(std::string(error.what()).find("BayerRG8"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Mono12p"), std::string::npos);
  }
}

TEST(PixelFormat, CountsTheBytesThatPadTheRows) {
  const auto& mono8 = pixel_format("Mono8");
  EXPECT_EQ(mono8.bytes(100, 50, 0), 5000U);
  EXPECT_EQ(mono8.bytes(100, 50, 28), 5000U + 49 * 28);
  EXPECT_EQ(mono8.bytes(100, 1, 28), 100U);
  EXPECT_EQ(pixel_format("Mono12").bytes(100, 50, 28), 10000U + 49 * 28);
  EXPECT_FALSE(pixel_format("Mono12").bytes(100, 50, 27)) << "a row would begin within a pixel";
  EXPECT_EQ(pixel_format("Mono12p").bytes(100, 50, 0), 7500U);
  EXPECT_FALSE(pixel_format("Mono12p").bytes(100, 50, 2));
}
