// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_programs/source_text.h"

#include <algorithm>
#include <stdexcept>

namespace tool_path_programs {
namespace {

bool before(const TextEdit& one, const TextEdit& other) {
  return std::pair(one.file, one.offset) < std::pair(other.file, other.offset);
}

std::string edited(const std::string& text, std::vector<TextEdit>::const_iterator edit,
                   std::vector<TextEdit>::const_iterator end) {
  std::string result;
  result.reserve(text.size());
  std::size_t at = 0;
  for (; edit != end; ++edit) {
    if (edit->offset < at || edit->offset + edit->length > text.size())
      throw std::logic_error("edits overlap or lie beyond their file");
    result.append(text, at, edit->offset - at).append(edit->text);
    at = edit->offset + edit->length;
  }
  return result.append(text, at);
}

}  // namespace

std::string to_string(const Place& place, const std::vector<SourceFile>& files) {
  return files.at(place.file).name + ", line " + std::to_string(place.line);
}

std::vector<SourceFile> edited(const std::vector<SourceFile>& files, std::vector<TextEdit> edits) {
  std::stable_sort(edits.begin(), edits.end(), before);
  std::vector<SourceFile> result = files;
  auto first = edits.cbegin();
  while (first != edits.cend()) {
    const auto last = std::find_if(first, edits.cend(),
                                   [&](const TextEdit& edit) { return edit.file != first->file; });
    result.at(first->file).text = edited(files.at(first->file).text, first, last);
    first = last;
  }
  return result;
}

}  // namespace tool_path_programs
