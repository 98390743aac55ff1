// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "history/database/database.h"
#include "history/history_filter.h"
#include "record/run_record.h"

namespace part_recipes {

/// A run as the history has it.
struct HistoryRun {
  std::int64_t sequence = 0;  //!< rises in the order in which the runs were added
  RunRecord record;           //!< without stages, files and calibration: those are in run.json only
};

/// A run.json that was read.
struct RunFile {
  RunRecord record;
  std::string sha256;  //!< of its bytes
};

/// Makes the tables in a new database, and checks that it is a history that this version reads.
/// @throw scan_cell_common::UnusableInput if it is from a newer version
/// @throw scan_cell_common::Refused if it belongs to another program
void prepare_history(Database& database, const std::string& cure);
void check_history(const Database& database, const std::string& cure);

/// Adds a run in the open transaction.
void insert_run(const Database& database, const RunFile& run);

/// The SHA-256 of the run.json that was added under an id; empty: there is none.
std::string sha256_in_history(const Database& database, const std::string& id);

/// Runs in the order in which they were added. The filter must be checked().
std::vector<HistoryRun> select_runs(Database& database, const HistoryFilter& filter);

/// The sequence of each run by its id.
std::map<std::string, std::int64_t> sequences(const Database& database);

}  // namespace part_recipes
