// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "record/work_records.h"

#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"

namespace part_recipes {
namespace fs = std::filesystem;
namespace {

WorkRecord read_work(const std::string& file) {
  try {
    const auto all = nlohmann::json::parse(scan_cell_common::read_file(file));
    return {all.at("finished").get<bool>(), all.at("passed").size()};
  } catch (const nlohmann::json::exception& error) {
    throw scan_cell_common::UnusableInput(file, error.what(), "restore it, or move it away");
  }
}

}  // namespace

std::vector<WorkRecord> work_records(const fs::path& run, bool dry) {
  const std::string wanted = run.string() + (dry ? ".dry_run" : ".work");
  std::vector<WorkRecord> records;
  std::string name = wanted;  // the names that free_name() gives, in their order
  for (int i = 2; fs::exists(name + ".json") || fs::exists(name + ".log"); ++i) {
    if (fs::exists(name + ".json")) {
      const WorkRecord record = read_work(name + ".json");
      if (record.passed > 0) records.push_back(record);
    }
    name = wanted + "_" + std::to_string(i);
  }
  return records;
}

}  // namespace part_recipes
