// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace part_recipes {

/// A recorded run that is to be done with another recipe.
struct Job {
  std::string id;                //!< of the recorded run
  std::filesystem::path run;     //!< its folder
  std::filesystem::path recipe;  //!< folder of the other recipe
};

/// Jobs in a folder that any number of workers share, on one machine or on many with a shared file
/// system. A worker claims a job by making a file that must not be there yet; a claim that its
/// worker no longer touches is free again. A result is linked into its place, which only one can:
/// no job is lost with its worker, and none counts twice.
///
///     FOLDER/jobs/ID.json     what to do
///     FOLDER/claims/ID        who does it; its time is when the worker last said that it lives
///     FOLDER/done/ID.json     the run that came out
///     FOLDER/runs/            the runs
class JobFolder {
 public:
  explicit JobFolder(std::filesystem::path folder);

  /// Adds jobs; those that are there already stay.
  /// @throw scan_cell_common::FileError
  void add(const std::vector<Job>& jobs) const;

  /// All, by id.
  /// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if one is broken
  std::vector<Job> jobs() const;

  std::vector<std::string> ids() const;       //!< of all jobs, sorted
  std::vector<std::string> open_ids() const;  //!< of those without a result, sorted

  /// Takes a job that nobody does.
  /// @param lease [s] after which a claim that is not touched is free again
  /// @return none: all are done, or somebody does them
  std::optional<Job> claim(std::chrono::seconds lease) const;

  /// Takes this job.
  /// @return none: it is done, or somebody does it
  std::optional<Job> claim(const std::string& id, std::chrono::seconds lease) const;

  /// Says that the worker of this job lives.
  void touch(const Job& job) const;

  /// Gives a job back that was not done.
  void release(const Job& job) const;

  /// Puts down the run that came out.
  /// @return false: another worker was first, and this run is of no use
  /// @throw scan_cell_common::FileError
  bool finish(const Job& job, const std::filesystem::path& run) const;

  /// The run that came out of a job; none: it is not done.
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
