// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/tool_path_files.h"

#include <filesystem>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::FileError;

enum class Format { kCsv, kYaml };

Format format_of(const std::string& path) {
  const std::string extension = scan_cell_common::extension_of(path);
  if (extension == ".csv") return Format::kCsv;
  if (extension == ".yaml" || extension == ".yml") return Format::kYaml;
  throw FileError(path, "ending '" + extension + "'", "give a tool path as .csv or .yaml");
}

void refuse_utf16(const std::string& text, const std::string& path) {
  if (text.substr(0, 2) != "\xff\xfe" && text.substr(0, 2) != "\xfe\xff") return;
  throw scan_cell_common::UnusableInput(path, "in UTF-16", "save it as UTF-8");
}

}  // namespace

void check_tool_path_name(const std::string& path) {
  format_of(path);
}

ToolPath load_tool_path(const std::string& path) {
  const Format format = format_of(path);
  const std::string text = scan_cell_common::read_file(path);
  refuse_utf16(text, path);
  ToolPath result =
      format == Format::kCsv ? parse_tool_path_csv(text, path) : parse_tool_path_yaml(text, path);
  if (result.name == path) result.name = std::filesystem::path(path).stem().string();
  return result;
}

void save_tool_path(const std::string& path, const ToolPath& tool_path) {
  const Format format = format_of(path);
  check(tool_path);
  scan_cell_common::save_text(
      path, format == Format::kCsv ? tool_path_to_csv(tool_path) : tool_path_to_yaml(tool_path));
}

}  // namespace tool_path_stretcher
