// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "tool_path_stretcher/tool_path_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/yaml_file.h"

namespace tool_path_stretcher {
namespace {

using scan_cell_common::FileError;

enum class Format { kCsv, kYaml };

Format format_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".csv") return Format::kCsv;
  if (extension == ".yaml" || extension == ".yml") return Format::kYaml;
  throw FileError(path, "ending '" + extension + "'", "give a tool path as .csv or .yaml");
}

std::string read_text(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) {
    throw FileError(path, "no such file", "check the path");
  }
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), {});
  if (!file) throw FileError(path, "cannot be read", "check its permissions");
  return text;
}

}  // namespace

void check_tool_path_name(const std::string& path) {
  format_of(path);
}

ToolPath load_tool_path(const std::string& path) {
  const Format format = format_of(path);
  const std::string text = read_text(path);
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
