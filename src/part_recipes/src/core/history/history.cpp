// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/history.h"

#include "disk/folder_lock.h"
#include "history/run_folders.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

namespace fs = std::filesystem;

using scan_cell_common::FileError;
using scan_cell_common::Refused;
using scan_cell_common::UnusableInput;

History::History(const fs::path& runs) : runs_(runs) {
  std::error_code failure;
  if (!fs::is_directory(runs, failure))
    throw FileError(runs.string(), "no such folder", "give the folder of the runs with --runs");
}

std::string History::cure() const {
  return "rebuild it from the runs: history rebuild --runs '" + runs_.string() + "'";
}

Database History::open_to_read() const {
  Database database(file(), Access::kRead, cure());
  check_history(database, cure());
  return database;
}

Database History::open_to_write(const fs::path& file) const {
  Database database(file, Access::kWrite, cure());
  prepare_history(database, cure());
  return database;
}

bool History::add(const fs::path& folder) const {
  std::error_code failure;
  const fs::path plain = folder.filename().empty() ? folder.parent_path() : folder;
  if (!fs::equivalent(fs::absolute(plain).parent_path(), runs_, failure))
    throw Refused(folder.string(), "not in " + runs_.string(), "copy the run into that folder");
  const RunFile run = read_run_file(plain);
  const FolderLock lock(runs_, FolderLock::Kind::kShared);
  Database database = open_to_write(file());
  Transaction transaction(database, Access::kWrite);
  const std::string known = sha256_in_history(database, run.record.id);
  if (known == run.sha256) return false;
  if (!known.empty())
    throw Refused(run.record.id, "in the history with a different run.json",
                  "restore the run's folder, or take it as it is now: history rebuild --runs '" +
                      runs_.string() + "'");
  insert_run(database, run);
  transaction.commit();
  return true;
}

std::vector<HistoryRun> History::query(const HistoryFilter& filter) const {
  const HistoryFilter asked = checked(filter);
  const FolderLock lock(runs_, FolderLock::Kind::kShared);
  Database database = open_to_read();
  return select_runs(database, asked);
}

HistoryRun History::find(const std::string& id) const {
  HistoryFilter filter;
  filter.id = id;
  const auto runs = query(filter);
  if (runs.empty())
    throw UnusableInput(id, "not in the history of " + runs_.string(),
                        "history list shows all of them");
  return runs.front();
}

std::vector<std::string> History::left_out() const {
  const FolderLock lock(runs_, FolderLock::Kind::kShared);
  const auto known = sequences(open_to_read());
  std::vector<std::string> names;
  for (const fs::path& folder :
       run_folders(runs_, [&known](const std::string& name) { return known.count(name) != 0; }))
    names.push_back(folder.filename().string());
  return names;
}

}  // namespace part_recipes
