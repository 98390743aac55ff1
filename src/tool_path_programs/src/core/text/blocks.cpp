// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "text/blocks.h"

namespace tool_path_programs {

std::vector<std::vector<Block>> filled(const std::vector<Block>& blocks, std::size_t lines) {
  std::vector<std::vector<Block>> files;
  std::size_t left = 0;
  for (const Block& block : blocks) {
    if (files.empty() || block.size() > left) {
      files.emplace_back();
      left = lines;
    }
    files.back().push_back(block);
    left -= block.size();
  }
  return files;
}

std::vector<std::string> comment_lines(const std::string& comment, std::size_t width) {
  std::vector<std::string> lines;
  std::string line;
  for (const char character : comment + "\n") {
    if (character == '\n' || line.size() == width) {
      lines.push_back(line);
      line.clear();
    }
    if (character != '\n' && character != '\r') line += character;
  }
  return lines;
}

}  // namespace tool_path_programs
