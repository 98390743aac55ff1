// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "replay/replay.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "run/again.h"
#include "scan_cell_common/errors/errors.h"
#include "tool_paths/tool_path_files.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// Called often while tools run: touches the claim from time to time.
class Heartbeat {
 public:
  Heartbeat(const JobFolder& folder, const Job& job, std::chrono::seconds lease, const Stop& stop)
      : folder_(folder), job_(job), period_(lease / 4), stop_(stop) {}

  bool operator()() {
    const auto now = std::chrono::steady_clock::now();
    if (now - touched_ >= period_) {
      folder_.touch(job_);
      touched_ = now;
    }
    return stop_ && stop_();
  }

 private:
  const JobFolder& folder_;
  const Job& job_;
  std::chrono::milliseconds period_;
  const Stop& stop_;
  std::chrono::steady_clock::time_point touched_ = std::chrono::steady_clock::now();
};

/// The jobs that a worker tries, in an order of its own. It lists the folder only when it knows no
/// more jobs, and workers seldom try what another one has just taken.
class OpenJobs {
 public:
  OpenJobs(const JobFolder& folder, std::chrono::seconds lease)
      : folder_(folder), lease_(lease), order_(static_cast<unsigned>(getpid())) {}

  /// @return none: every job is done, or somebody is working on it
  std::optional<Job> next() {
    if (auto job = next_known()) return job;
    ids_ = folder_.open_ids();
    std::shuffle(ids_.begin(), ids_.end(), order_);
    return next_known();
  }

 private:
  std::optional<Job> next_known() {
    while (!ids_.empty()) {
      const std::string id = std::move(ids_.back());
      ids_.pop_back();
      if (auto job = folder_.claim(id, lease_)) return job;
    }
    return std::nullopt;
  }

  const JobFolder& folder_;
  const std::chrono::seconds lease_;
  std::mt19937 order_;
  std::vector<std::string> ids_;
};

void do_job(const JobFolder& folder, const Job& job, std::chrono::seconds lease, const Stop& stop) {
  const EndedRun run = run_with(job.run, load_recipe(job.recipe), folder.runs(),
                                Heartbeat(folder, job, lease, stop));
  if (!folder.finish(job, run.folder)) fs::remove_all(run.folder);
}

std::optional<tool_paths::Points> path_of(const fs::path& run) {
  for (const char* name : {"adapted_path.csv", "adapted_path.yaml", "adapted_path.yml"}) {
    if (fs::exists(run / name))
      return tool_paths::positions_of(tool_paths::load_tool_path((run / name).string()));
  }
  return std::nullopt;
}

void compare_paths(const fs::path& before, const fs::path& after, ReplayedRun& run) {
  const auto one = path_of(before);
  const auto other = path_of(after);
  if (!one || !other || one->empty() || one->size() != other->size()) return;
  double squares = 0, most = 0;
  for (std::size_t i = 0; i < one->size(); ++i) {
    const double distance = ((*one)[i] - (*other)[i]).norm();
    squares += distance * distance;
    most = std::fmax(most, distance);
  }
  run.moved_rms = std::sqrt(squares / static_cast<double>(one->size()));
  run.moved_most = most;
}

std::string outcome(const RunRecord& record) {
  return to_string(record.state) +
         (record.state == RunState::kAccepted ? "" : " (" + record.reason + ")");
}

}  // namespace

std::size_t work_on(const JobFolder& folder, std::chrono::seconds lease, const JobBegins& begins,
                    const Stop& stop) {
  std::size_t done = 0;
  OpenJobs open(folder, lease);
  while (!(stop && stop())) {
    const auto job = open.next();
    if (!job) break;
    if (begins) begins(job->id);
    try {
      do_job(folder, *job, lease, stop);
    } catch (...) {
      folder.release(*job);
      throw;
    }
    ++done;
  }
  return done;
}

std::vector<ReplayedRun> replayed(const JobFolder& folder) {
  std::vector<ReplayedRun> runs;
  for (const Job& job : folder.jobs()) {
    const auto result = folder.result(job.id);
    if (!result) continue;
    ReplayedRun run;
    run.id = job.id;
    run.before = load_run(job.run);
    run.after = load_run(*result);
    compare_paths(job.run, *result, run);
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string to_text(const std::vector<ReplayedRun>& runs) {
  std::string text;
  std::size_t changed = 0;
  double most = 0;
  for (const ReplayedRun& run : runs) {
    const std::string before = outcome(run.before), after = outcome(run.after);
    changed += before == after ? 0 : 1;
    text += fmt::format("{}  {}{}", run.id, before, before == after ? "" : " -> " + after);
    if (run.moved_most) {
      text += fmt::format(", waypoints moved {:.3f} mm RMS, {:.3f} mm at most",
                          1e3 * *run.moved_rms, 1e3 * *run.moved_most);
      most = std::fmax(most, *run.moved_most);
    }
    text += "\n";
  }
  return text + fmt::format("{} runs: {} verdicts changed, waypoints moved by up to {:.3f} mm\n",
                            runs.size(), changed, 1e3 * most);
}

}  // namespace part_recipes
