// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <tuple>

#include "disk/folder_lock.h"
#include "disk/to_disk.h"
#include "history/history.h"
#include "history/run_folders.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::Error;
using scan_cell_common::FileError;
using scan_cell_common::UnusableInput;

constexpr const char* kNewFile = ".history.sqlite.new";

/// Removes SQLite's files beside a database: with those of another database it would be damaged.
void remove_beside(const fs::path& file) {
  for (const char* ending : {"-wal", "-shm", "-journal"})
    fs::remove(file.string() + ending);
}

/// Sorts the runs as rebuild() promises.
/// @param known place of each run in the old order, by its id
void sort(std::vector<RunFile>& runs, const std::map<std::string, std::int64_t>& known) {
  std::map<std::string, std::int64_t> last;  // place of the last run that started not after a time
  for (const RunFile& run : runs) {
    if (const auto place = known.find(run.record.id); place != known.end())
      last[run.record.started] = std::max(last[run.record.started], place->second);
  }
  std::int64_t highest = 0;
  for (auto& [time, place] : last)
    place = highest = std::max(highest, place);
  const auto key = [&](const RunFile& run) {
    const auto place = known.find(run.record.id);
    if (place != known.end()) return std::make_tuple(place->second, std::string(), run.record.id);
    const auto after = last.upper_bound(run.record.started);
    const std::int64_t behind = after == last.begin() ? 0 : std::prev(after)->second;
    return std::make_tuple(behind, run.record.started, run.record.id);
  };
  std::sort(runs.begin(), runs.end(),
            [&key](const RunFile& one, const RunFile& other) { return key(one) < key(other); });
}

std::vector<RunFile> read_all(const fs::path& runs, Rebuilt& result) {
  std::vector<RunFile> all;
  for (const fs::path& folder : run_folders(runs, [](const std::string&) { return false; })) {
    try {
      all.push_back(read_run_file(folder));
    } catch (const Error& error) {
      result.broken.emplace_back(folder.filename().string(), error.what());
    }
  }
  return all;
}

void fill(Database& database, const std::vector<RunFile>& runs) {
  Transaction transaction(database, Access::kWrite);
  for (const RunFile& run : runs)
    insert_run(database, run);
  transaction.commit();
}

}  // namespace

Rebuilt History::rebuild() const {
  if (access(runs_.c_str(), W_OK) != 0)
    throw FileError(runs_.string(), "cannot be written", "check the folder's permissions");
  const FolderLock lock(runs_, FolderLock::Kind::kAlone);
  Rebuilt result;
  std::map<std::string, std::int64_t> known;
  std::error_code none;
  const bool has_old = fs::exists(file(), none);
  if (has_old && fs::file_size(file(), none) == 0) result.order_lost = "empty";
  try {
    if (has_old && result.order_lost.empty()) known = sequences(open_to_read());
  } catch (const UnusableInput& error) {
    result.order_lost = error.value();
  }
  std::vector<RunFile> runs = read_all(runs_, result);
  sort(runs, known);
  try {
    put_in_place(runs, has_old && result.order_lost.empty());
  } catch (const fs::filesystem_error& error) {
    throw FileError(error.path1().string(), error.code().message(),
                    "check the folder, its permissions and the disk");
  }
  result.runs = runs.size();
  for (const RunFile& run : runs)
    known.erase(run.record.id);
  for (const auto& [id, sequence] : known)
    result.gone.push_back(id);
  return result;
}

void History::put_in_place(const std::vector<RunFile>& runs, bool is_old_readable) const {
  const fs::path made = runs_ / kNewFile;
  fs::remove(made);
  remove_beside(made);
  {
    Database database = open_to_write(made);
    fill(database, runs);
  }
  to_disk(made);
  if (is_old_readable) {
    // All of it goes into the one file: until the other replaces it, this one holds every run.
    Database old(file(), Access::kWrite, cure());
    old.execute("PRAGMA journal_mode = DELETE");
  }
  remove_beside(file());
  fs::rename(made, file());
  to_disk(runs_);
}

}  // namespace part_recipes
