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

/// What became of a rebuild.
struct Rebuilt {
  std::size_t runs = 0;                                     //!< in the new database
  std::vector<std::pair<std::string, std::string>> broken;  //!< folder and what is wrong with it
  std::vector<std::string> gone;  //!< ids of the old database that have no folder any more
  std::string order_lost;  //!< why the old order could not be kept, the runs are by their start
                           //!< now; empty: it was, or there was none
};

/// The runs of a folder as rows of an SQLite database in it. The folders are what counts: the
/// database can be made anew from them at any time. Each call opens the database and closes it, so
/// that several programs may read while one writes.
///
/// Errors of every call: scan_cell_common::UnusableInput where the database is damaged or from a
/// newer version; ...::FileError where folder or database is missing or cannot be read or written;
/// ...::Refused where it belongs to another program, or one keeps it too long. Each names the file
/// and the cure.
class History {
 public:
  /// @param runs folder of the runs
  /// @throw scan_cell_common::FileError if there is no such folder
  explicit History(const std::filesystem::path& runs);

  /// Adds a run by its run.json. When this returns, the run stays, whatever ends the program or
  /// the machine.
  /// @param folder of the run, in the folder of the runs
  /// @return false: it was there already, nothing was changed
  /// @throw as above; UnusableInput also where run.json is broken; Refused also where the history
  /// has another run of that id
  bool add(const std::filesystem::path& folder) const;

  /// Makes the database anew from the folders. Readers and writers wait meanwhile; a program that
  /// is killed leaves the old database. Folders whose name begins with a dot or that have no
  /// run.json are no runs; a run.json that is broken is told and does not stop it. Runs that the
  /// old database has keep their order, others come behind the last one that did not start later.
  Rebuilt rebuild() const;

  /// Runs in the order in which they were added, with the places' deviations.
  /// @throw as above; scan_cell_common::InvalidParameter naming a bad value of the filter
  std::vector<HistoryRun> query(const HistoryFilter& filter) const;

  /// One run.
  /// @throw as above; scan_cell_common::UnusableInput also if it is not in the history
  HistoryRun find(const std::string& id) const;

  /// Names of the folders that hold a run which the history does not have: the program that made
  /// it was ended before it could add it.
  std::vector<std::string> left_out() const;

  const std::filesystem::path& folder() const { return runs_; }  //!< of the runs

 private:
  std::filesystem::path file() const { return runs_ / kHistoryFile; }
  std::string cure() const;
  Database open_to_read() const;
  Database open_to_write(const std::filesystem::path& file) const;

  /// Makes a database of the runs, then puts it into the place of the old one.
  void put_in_place(const std::vector<RunFile>& runs, bool is_old_readable) const;

  std::filesystem::path runs_;
};

}  // namespace part_recipes
