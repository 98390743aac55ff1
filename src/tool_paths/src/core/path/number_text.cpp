// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "path/number_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace tool_paths {

std::string to_text(double number) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() ? std::string(text.data(), end) : "nan";
}

}  // namespace tool_paths
