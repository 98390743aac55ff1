// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "history/history_filter.h"
#include "history/history_rows.h"

namespace part_recipes {

/// File of the database, beside the folders of the runs.
constexpr const char* kHistoryFile = "history.sqlite";

/// Result of a rebuild.
struct Rebuilt {
  std::size_t runs = 0;                                     //!< in the new database
  std::vector<std::pair<std::string, std::string>> broken;  //!< folder and what is wrong with it
  std::vector<std::string> gone;  //!< ids of the old database that have no folder any more
  std::string order_lost;  //!< why the old order could not be kept, the runs are by their start
                           //!< now; empty: it was, or there was none
};

/// The runs of a folder as rows of an SQLite database in that folder. The runs' folders are what
/// counts: the database can be rebuilt from them at any time. Each call opens and closes the
/// database, so that several programs may read while one writes.
///
/// Errors of every call: scan_cell_common::UnusableInput if the database is damaged or from a newer
/// version; ...::FileError if folder or database is missing or cannot be read or written;
/// ...::Refused if it belongs to another program, or a program keeps it too long. Each names the
/// file and the cure.
class History {
 public:
  /// @param runs folder of the runs
  /// @throw scan_cell_common::FileError if there is no such folder
  explicit History(const std::filesystem::path& runs);

  /// Adds a run by its run.json. Once this returns, the run stays in the history, whatever ends the
  /// program or the machine.
  /// @param folder of the run, in the folder of the runs
  /// @return false: it was there already, and nothing was changed
  /// @throw as above; UnusableInput also if run.json is broken; Refused also if the history has
  /// another run with that id
  bool add(const std::filesystem::path& folder) const;

  /// Rebuilds the database from the folders. Readers and writers wait meanwhile; a program that is
  /// killed leaves the old database. Folders whose name begins with a dot or that have no run.json
  /// are not runs; a broken run.json is reported and does not stop the rebuild. Runs in the old
  /// database keep their order. Each other run comes after the last one that did not start later.
  Rebuilt rebuild() const;

  /// Runs in the order in which they were added, with the places' deviations.
  /// @throw as above; scan_cell_common::InvalidParameter naming a bad value of the filter
  std::vector<HistoryRun> query(const HistoryFilter& filter) const;

  /// One run.
  /// @throw as above; scan_cell_common::UnusableInput also if it is not in the history
  HistoryRun find(const std::string& id) const;

  /// Names of the folders with a run that the history does not have: the program that made the run
  /// ended before it could add it.
  std::vector<std::string> left_out() const;

  const std::filesystem::path& folder() const { return runs_; }  //!< of the runs

 private:
  std::filesystem::path file() const { return runs_ / kHistoryFile; }
  std::string cure() const;
  Database open_to_read() const;
  Database open_to_write(const std::filesystem::path& file) const;

  /// Makes a database of the runs, then replaces the old one with it.
  void put_in_place(const std::vector<RunFile>& runs, bool is_old_readable) const;

  std::filesystem::path runs_;
};

}  // namespace part_recipes
