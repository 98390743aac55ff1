// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

inline bool names(const std::string& text, const std::string& word) {
  return text.find(word) != std::string::npos;
}

/// The error of a reader for a text that it cannot use; empty if it can.
template <class Read>
std::string complaint_of(const Read& read) {
  try {
    read();
  } catch (const scan_cell_common::UnusableInput& error) {
    return error.what();
  }
  return "";
}

inline std::string yaml_complaint(const std::string& text) {
  return complaint_of([&] { tool_paths::parse_tool_path_yaml(text, "path.yaml"); });
}
