// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

namespace tool_paths {

/// All documents of a text, including empty ones.
/// @param source names the text in errors
/// @throw scan_cell_common::UnusableInput if a part of it is not YAML or not UTF-8
std::vector<YAML::Node> load_documents(const std::string& text, const std::string& source);

/// File and line, as named in errors.
std::string line_of(const std::string& source, const YAML::Mark& mark);

/// The keys of a map and their values.
/// @throw scan_cell_common::UnusableInput if a key is not text, or occurs twice
std::vector<std::pair<std::string, YAML::Node>> entries_of(const YAML::Node& map,
                                                           const std::string& source);

}  // namespace tool_paths
