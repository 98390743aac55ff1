// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

namespace tool_path_stretcher {

/// All documents of a text, empty ones too.
/// @param source names the text in errors
/// @throw scan_cell_common::UnusableInput if a part of it is no YAML
std::vector<YAML::Node> load_documents(const std::string& text, const std::string& source);

}  // namespace tool_path_stretcher
