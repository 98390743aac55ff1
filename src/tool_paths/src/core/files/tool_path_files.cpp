// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_paths/tool_path_files.h"

#include <filesystem>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace tool_paths {
namespace {

using scan_cell_common::FileError;

enum class Format { kCsv, kYaml };

Format format_of(const std::string& path) {
  const std::string extension = scan_cell_common::extension_of(path);
  if (extension == ".csv") return Format::kCsv;
  if (extension == ".yaml" || extension == ".yml") return Format::kYaml;
  throw FileError(path, "extension '" + extension + "'", "give a tool path as .csv or .yaml");
}

}  // namespace

void check_tool_path_name(const std::string& path) {
  scan_cell_common::check_output(path, {".csv", ".yaml", ".yml"},
                                 "give a tool path as .csv or .yaml");
}

ToolPathFile load_tool_path_file(const std::string& path, const PathConventions& conventions) {
  const Format format = format_of(path);
  const std::string text = scan_cell_common::read_file(path);
  ToolPathFile file = format == Format::kCsv ? parse_tool_path_csv(text, path, conventions)
                                             : parse_tool_path_yaml(text, path, conventions);
  if (file.path.name == path) file.path.name = std::filesystem::path(path).stem().string();
  return file;
}

ToolPath load_tool_path(const std::string& path, const PathConventions& conventions) {
  return load_tool_path_file(path, conventions).path;
}

void save_tool_path(const std::string& path, const ToolPath& tool_path, const PathLayout& layout) {
  const Format format = format_of(path);
  check(tool_path);
  scan_cell_common::save_text(path, format == Format::kCsv ? tool_path_to_csv(tool_path, layout)
                                                           : tool_path_to_yaml(tool_path, layout));
}

}  // namespace tool_paths
