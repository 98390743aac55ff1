// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history_replay.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <thread>

#include "history/history.h"
#include "recipe/recipe.h"
#include "replay/replay.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

namespace fs = std::filesystem;

using part_recipes::JobFolder;

void add_jobs(const ReplayOptions& options, const JobFolder& folder) {
  if (options.runs.empty()) return;
  if (options.recipe.empty())
    throw scan_cell_common::InvalidParameter("--recipe", "not given", "give a recipe's folder");
  part_recipes::load_recipe(options.recipe);  // before a thousand workers find out
  std::vector<part_recipes::Job> jobs;
  for (const auto& run : part_recipes::History(options.runs).query(options.recorded))
    jobs.push_back({run.record.id, fs::path(options.runs) / run.record.id, options.recipe});
  folder.add(jobs);
}

int work(const ReplayOptions& options, const JobFolder& folder) {
  const auto begins = [](const std::string& id) { std::printf("%s\n", id.c_str()); };
  work_on(folder, std::chrono::seconds(options.lease), begins,
          scan_cell_common::CatchInterrupts::interrupted);
  return 0;
}

/// @return whether all of them ended well
bool work_side_by_side(const ReplayOptions& options, const JobFolder& folder) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const unsigned count = options.workers == 0 ? cores : options.workers;
  std::vector<pid_t> workers;
  for (unsigned i = 0; i < count; ++i) {
    const pid_t worker = fork();
    if (worker < 0) throw scan_cell_common::Refused("a worker", "no process", "end other programs");
    if (worker == 0) {
      try {
        _exit(work(options, folder));
      } catch (const std::exception& error) {
        std::fprintf(stderr, "history replay: %s\n", error.what());
        _exit(scan_cell_common::kUnusable);
      }
    }
    workers.push_back(worker);
  }
  bool well = true;
  for (const pid_t worker : workers) {
    int status = 0;
    while (waitpid(worker, &status, 0) < 0 && errno == EINTR)
      kill(worker, SIGINT);
    well = well && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  return well;
}

}  // namespace

void add_query(CLI::App& app, part_recipes::HistoryFilter& filter) {
  app.add_option("--state", filter.state, "accepted, refused or unusable");
  app.add_option("--reason", filter.reason, "reason of the verdict, such as wrong_part");
  app.add_option("--since", filter.since,
                 "earliest start in UTC, to any precision: 2026-11, 2026-11-25T12:13");
  app.add_option("--until", filter.until,
                 "latest start, in the same way; includes all that begin with it");
  app.add_option("--limit", filter.limit, "number of runs: only the last ones");
  app.add_option("--text", filter.text,
                 "text anywhere in id, recipe, reason, message, host or note");
}

CLI::App* add_replay(CLI::App& app, ReplayOptions& options) {
  CLI::App* const command = app.add_subcommand("replay",
                                               "runs recorded scans again with another recipe or "
                                               "version and compares run by run; any number "
                                               "of machines may work on the same jobs");
  add_query(*command, options.recorded);
  command->add_option("--recorded-recipe", options.recorded.recipe, "only runs of this recipe");
  command->add_option("--recipe", options.recipe, "folder of the recipe to run them with");
  command->add_flag("--only-add", options.only_add, "adds the jobs and leaves them to others");
  const auto of_added_runs = command->get_options();
  auto* const runs = command->add_option(
      "--runs", options.runs,
      "folder of the recorded runs to add; without it, only works on jobs that are there");
  for (CLI::Option* const option : of_added_runs)
    if (option != command->get_help_ptr()) option->needs(runs);
  command->add_option("--jobs", options.jobs, "folder that all workers share; made if missing")
      ->required();
  command->add_option("--workers", options.workers, "processes on this machine; 0: one per core");
  command
      ->add_option("--lease", options.lease,
                   "a job goes to another worker if its own is silent for this long [s]")
      ->check(CLI::Range(1U, 86400U))
      ->capture_default_str();
  return command;
}

int replay(const ReplayOptions& options) {
  const scan_cell_common::CatchInterrupts interrupts;
  const JobFolder folder(options.jobs);
  add_jobs(options, folder);
  if (options.only_add) {
    std::printf("%zu jobs\n", folder.ids().size());
    return 0;
  }
  const bool well = work_side_by_side(options, folder);
  const auto done = replayed(folder);
  std::fputs(to_text(done).c_str(), stdout);
  const std::size_t left = folder.ids().size() - done.size();
  if (left > 0) std::printf("%zu runs are left: other workers do them, or run this again\n", left);
  return well && left == 0 ? 0 : scan_cell_common::kUnusable;
}
