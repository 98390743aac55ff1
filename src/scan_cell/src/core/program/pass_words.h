// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "scan_cell/scan_request.h"

namespace scan_cell {

/// Words for the lasers in a program's file, in the order of PassLasers.
constexpr std::array kLaserWords = {"0", "1", "each", "alternate"};

/// Words for the ways in a program's file, in the order of PassKind, which begins with 1.
constexpr std::array kWayWords = {"line", "arc", "poses"};

inline const char* word_of(PassLasers lasers) {
  return kLaserWords.at(static_cast<std::size_t>(lasers));
}
inline const char* word_of(PassKind kind) {
  return kWayWords.at(static_cast<std::size_t>(kind) - 1);
}

}  // namespace scan_cell
