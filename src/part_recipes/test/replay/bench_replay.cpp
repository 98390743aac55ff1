// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Costs of handing out jobs through a shared folder, beside the minimum that a file system needs;
// and, from these, a simulation of how a replay scales with machines.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <queue>

#include "replay/job_folder.h"
#include "scan_cell_common/tools/tool_main.h"
#include "temporary_folder.h"

namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;
using part_recipes::Job;
using part_recipes::JobFolder;

struct Options {
  std::size_t jobs = 10000;
  double run_seconds = 3.4;        // of one run on one core
  double run_megabytes = 12;       // that a run reads and writes in the shared folder
  double server_megabytes = 1100;  // [1/s] of the shared folder: a line of 10 Gbit/s
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<Job> some_jobs(std::size_t count) {
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < count; ++i)
    jobs.push_back({"run_" + std::to_string(1000000 + i), "/run", "/recipe"});
  return jobs;
}

/// Makes two small files and removes one: handing out a contested job cannot take less.
double yardstick(const fs::path& folder, std::size_t jobs) {
  fs::create_directories(folder);
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < jobs; ++i) {
    const fs::path claim = folder / ("claim" + std::to_string(i));
    std::ofstream(claim) << "worker";
    std::ofstream(folder / ("done" + std::to_string(i))) << "run";
    fs::remove(claim);
  }
  return seconds_since(start) / static_cast<double>(jobs);
}

/// @return [s] time to claim and finish a job
double hand_out(const JobFolder& folder) {
  const std::chrono::seconds lease(60);
  const Clock::time_point start = Clock::now();
  std::size_t done = 0;
  for (const std::string& id : folder.open_ids()) {
    const auto job = folder.claim(id, lease);
    if (job && folder.finish(*job, folder.runs() / id)) ++done;
  }
  return seconds_since(start) / static_cast<double>(done);
}

/// Share of the workers' time that is spent on runs. Every job asks the shared folder, which serves
/// one after another, for its claim and its data; then it runs.
double efficiency(std::size_t workers, const Options& options, double hand_out_seconds) {
  const double asked = hand_out_seconds + options.run_megabytes / options.server_megabytes;
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (std::size_t i = 0; i < workers; ++i)
    free_at.push(0);
  double served = 0, last = 0;
  for (std::size_t i = 0; i < options.jobs; ++i) {
    served = std::max(served, free_at.top()) + asked;
    free_at.pop();
    last = std::max(last, served + options.run_seconds);
    free_at.push(served + options.run_seconds);
  }
  return static_cast<double>(options.jobs) * options.run_seconds /
         (static_cast<double>(workers) * last);
}

void run(const Options& options) {
  const part_recipes::TemporaryFolder temporary;
  const double least = yardstick(temporary.path() / "yardstick", options.jobs);
  const JobFolder folder(temporary.path() / "jobs");
  folder.add(some_jobs(options.jobs));
  const double taken = hand_out(folder);
  std::printf("%zu jobs through a folder, on this disk\n", options.jobs);
  std::printf("  a job claimed and finished  %7.3f ms\n", 1e3 * taken);
  std::printf("  two files made, one removed %7.3f ms   %.1f times\n\n", 1e3 * least,
              taken / least);
  std::printf("simulated: %zu runs of %.1f s and %.0f MB, a shared folder of %.0f MB/s\n",
              options.jobs, options.run_seconds, options.run_megabytes, options.server_megabytes);
  for (const std::size_t workers : {1, 2, 10, 100, 300, 1000})
    std::printf("  %4zu workers: efficiency %3.0f %%\n", workers,
                100 * efficiency(workers, options, taken));
  const double data = options.run_megabytes / options.server_megabytes;
  std::printf("  full from %.0f workers on: %.0f %% of what a job asks of the folder is its data\n",
              options.run_seconds / (taken + data), 100 * data / (taken + data));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("How jobs are handed out, and how a replay grows with machines");
  Options options;
  app.add_option("--jobs", options.jobs)->capture_default_str();
  app.add_option("--run-seconds", options.run_seconds, "of a run on one core")
      ->capture_default_str();
  app.add_option("--run-megabytes", options.run_megabytes, "that a run reads and writes")
      ->capture_default_str();
  app.add_option("--server-megabytes", options.server_megabytes, "a second, of the shared folder")
      ->capture_default_str();
  return scan_cell_common::tool_main("bench_replay", app, argc, argv, [&] {
    run(options);
    return 0;
  });
}
