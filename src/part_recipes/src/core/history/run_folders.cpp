// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/run_folders.h"

#include <algorithm>

#include "history/history_filter.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/sha256.h"

namespace part_recipes {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

std::vector<fs::path> run_folders(const fs::path& runs,
                                  const std::function<bool(const std::string&)>& is_known) {
  std::vector<fs::path> folders;
  try {
    for (const auto& entry : fs::directory_iterator(runs)) {
      const std::string name = entry.path().filename().string();
      if (name.front() == '.' || is_known(name) || !entry.is_directory()) continue;
      std::error_code failure;  // an unreadable one is reported when it is read
      if (fs::exists(entry.path() / kRunFile, failure) || failure) folders.push_back(entry.path());
    }
  } catch (const fs::filesystem_error& error) {
    throw FileError(error.path1().string(), error.code().message(),
                    "check the folder and its permissions");
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

RunFile read_run_file(const fs::path& folder) {
  const std::string file = (folder / kRunFile).string();
  RunFile run{load_run(folder), scan_cell_common::sha256_of_file(file)};
  const RunRecord& record = run.record;
  if (record.id != folder.filename().string())
    throw UnusableInput(file, "id '" + record.id + "'", "give the folder the name of its run");
  for (const std::string& time : {record.started, record.ended}) {
    if (!is_whole_time(time))
      throw UnusableInput(file, "time '" + time + "'",
                          "write times in UTC such as 2026-11-25T12:13:14.123Z");
  }
  return run;
}

}  // namespace part_recipes
