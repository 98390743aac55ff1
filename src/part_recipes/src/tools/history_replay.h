// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "history/history_filter.h"

/// Which recorded runs are repeated, with which recipe, and where the jobs are.
struct ReplayOptions {
  std::string jobs;                      //!< folder that the workers share
  std::string runs;                      //!< recorded runs; empty: no jobs are added
  std::string recipe;                    //!< folder of the recipe to use
  part_recipes::HistoryFilter recorded;  //!< of the runs
  unsigned workers = 0;                  //!< processes here; 0: one a core
  bool only_add = false;                 //!< leave the jobs to others
  unsigned lease = 60;                   //!< [s] after which a silent worker loses its job
};

/// Adds the options that choose runs from a history, except the name of their recipe.
void add_query(CLI::App& app, part_recipes::HistoryFilter& filter);

/// The command that replay() carries out.
CLI::App* add_replay(CLI::App& app, ReplayOptions& options);

/// Adds the jobs, works on them and prints the comparison.
/// @return the process's exit code: 0 if all jobs are done
/// @throw scan_cell_common::InvalidParameter if runs are to be added without a recipe
int replay(const ReplayOptions& options);
