// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace scan_cell_sim::gige {

/// Appends numbers in network order.
inline void put16(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  bytes.push_back(static_cast<std::uint8_t>(value >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

inline void put32(std::vector<std::uint8_t>& bytes, std::uint64_t value) {
  put16(bytes, static_cast<std::uint32_t>(value >> 16U & 0xffffU));
  put16(bytes, static_cast<std::uint32_t>(value & 0xffffU));
}

inline std::uint32_t get16(const std::uint8_t* bytes) {
  return static_cast<std::uint32_t>(bytes[0] << 8 | bytes[1]);
}

inline std::uint32_t get32(const std::uint8_t* bytes) {
  return get16(bytes) << 16U | get16(bytes + 2);
}

}  // namespace scan_cell_sim::gige
