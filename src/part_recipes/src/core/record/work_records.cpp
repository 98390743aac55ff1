// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "record/work_records.h"

#include <nlohmann/json.hpp>

#include "record/record_names.h"
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
  std::vector<WorkRecord> records;
  for (const std::string& name : taken_names(run.string() + (dry ? ".dry_run" : ".work"))) {
    if (!fs::exists(name + ".json")) continue;  // the tool did not get that far
    const WorkRecord record = read_work(name + ".json");
    if (record.passed > 0) records.push_back(record);
  }
  return records;
}

}  // namespace part_recipes
