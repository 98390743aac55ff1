// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/scan_program.h"

#include <fmt/format.h>

#include "scan_cell_common/files/yaml_file.h"

namespace scan_cell {

ScanProgram load_scan_program(const std::string& path) {
  const auto root = scan_cell_common::YamlEntry::load(path);
  root.refuse_unknown({"frame", "start", "end", "speed", "rate", "laser"});
  ScanProgram program;
  program.frame = root["frame"].as<std::string>();
  program.request.start = root["start"].pose();
  program.request.end = root["end"].pose();
  program.request.speed = root["speed"].as<double>();
  program.request.rate = root["rate"].as<double>();
  const int laser = root["laser"].as<int>();
  if (laser < 0 || laser > 1) root["laser"].refuse(fmt::format("{}", laser), "give 0 or 1");
  program.request.lasers = static_cast<std::uint8_t>(1 << laser);
  return program;
}

}  // namespace scan_cell
