// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

namespace scan_cell_common {

/// A number in a binary file.
enum class Scalar { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

inline std::size_t size_of(Scalar scalar) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(scalar)];
}

inline bool is_real(Scalar scalar) {
  return scalar == Scalar::kFloat || scalar == Scalar::kDouble;
}

template <class Number>
Number load_as(const char* bytes, bool big_endian) {
  char ordered[sizeof(Number)];
  for (std::size_t i = 0; i < sizeof(Number); ++i)
    ordered[i] = bytes[big_endian ? sizeof(Number) - 1 - i : i];
  Number number;
  std::memcpy(&number, ordered, sizeof(number));
  return number;
}

/// The float nearest to a number; infinite beyond the range of floats.
inline float to_float(double number) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (number > kMost) return std::numeric_limits<float>::infinity();
  if (number < -kMost) return -std::numeric_limits<float>::infinity();
  return static_cast<float>(number);
}

/// @param real kFloat or kDouble
inline float load_float(const char* bytes, Scalar real, bool big_endian) {
  if (real == Scalar::kDouble) return to_float(load_as<double>(bytes, big_endian));
  return load_as<float>(bytes, big_endian);
}

}  // namespace scan_cell_common
