// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "history/history.h"

/// Prints the runs as a table for people.
void print_list(const std::vector<part_recipes::HistoryRun>& runs);

/// Prints everything that the history has of a run.
void print_run(const part_recipes::HistoryRun& run, const std::filesystem::path& runs);

/// Prints the result of a rebuild.
/// @return the process's exit code: not 0 if a run is broken
int print_rebuilt(const part_recipes::Rebuilt& rebuilt, const std::filesystem::path& runs);

/// Warns of runs that the history does not have.
void warn_of_left_out(const part_recipes::History& history);
