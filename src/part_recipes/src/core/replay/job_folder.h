// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace part_recipes {

/// A recorded run to be repeated with another recipe.
struct Job {
  std::string id;                //!< of the recorded run
  std::filesystem::path run;     //!< its folder
  std::filesystem::path recipe;  //!< folder of the other recipe
};

/// Jobs in a folder shared by any number of workers, on one machine or on many with a shared file
/// system. A worker claims a job by making a file that must not exist yet; a claim that its worker
/// no longer touches is free again. A result is linked into its place, which only one worker can
/// do: no job is lost with its worker, and none counts twice.
///
///     FOLDER/jobs/ID.json     what to do
///     FOLDER/claims/ID        who does it; its time is the worker's last sign of life
///     FOLDER/done/ID.json     the resulting run
///     FOLDER/runs/            the runs
class JobFolder {
 public:
  explicit JobFolder(std::filesystem::path folder);

  /// Adds jobs. Existing ones stay.
  /// @throw scan_cell_common::FileError
  void add(const std::vector<Job>& jobs) const;

  /// All jobs, by id.
  /// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if one is broken
  std::vector<Job> jobs() const;

  std::vector<std::string> ids() const;       //!< of all jobs, sorted
  std::vector<std::string> open_ids() const;  //!< of those without a result, sorted

  /// Takes a job that nobody is working on.
  /// @param lease [s] after which a claim that is not touched is free again
  /// @return none: every job is done, or somebody is working on it
  std::optional<Job> claim(std::chrono::seconds lease) const;

  /// Takes this job.
  /// @return none: it is done, or somebody is working on it
  std::optional<Job> claim(const std::string& id, std::chrono::seconds lease) const;

  /// Gives a sign of life of this job's worker.
  void touch(const Job& job) const;

  /// Gives back a job that was not done.
  void release(const Job& job) const;

  /// Records the resulting run.
  /// @return false: another worker was first, and this run is useless
  /// @throw scan_cell_common::FileError
  bool finish(const Job& job, const std::filesystem::path& run) const;

  /// The run that resulted from a job; none: it is not done.
  std::optional<std::filesystem::path> result(const std::string& id) const;

  std::filesystem::path runs() const { return folder_ / "runs"; }

 private:
  std::filesystem::path claim_of(const std::string& id) const { return folder_ / "claims" / id; }
  std::filesystem::path job_of(const std::string& id) const;
  std::filesystem::path done_of(const std::string& id) const;
  bool take(const std::string& id, std::chrono::seconds lease) const;

  std::filesystem::path folder_;
};

}  // namespace part_recipes
