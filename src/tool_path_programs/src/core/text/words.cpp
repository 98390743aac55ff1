// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/words.h"

#include <algorithm>

namespace tool_path_programs {

Words words_of(std::string_view list) {
  Words words;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(' '), list.size());
    words.insert(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return words;
}

}  // namespace tool_path_programs
