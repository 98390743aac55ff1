// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "view/waypoints_concerned.h"

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {

std::vector<std::uint32_t> waypoints_concerned(const std::filesystem::path& run) {
  const std::filesystem::path file = run / "report.json";
  if (!std::filesystem::exists(file)) return {};
  const std::string text = scan_cell_common::read_file(file.string());
  try {
    return nlohmann::json::parse(text).at("waypoints_concerned").get<std::vector<std::uint32_t>>();
  } catch (const std::exception& error) {
    throw scan_cell_common::UnusableInput(file.string(), error.what(), "run the part again");
  }
}

}  // namespace part_recipes
