// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "record/run_record.h"

namespace part_recipes {

/// Folder in which a run gathers its files until it is whole. It lies beside the other runs under a
/// name that begins with a dot, which nobody takes for a run; seal() gives it its name. A run that
/// is not sealed is removed; one that was killed leaves its dotted folder behind.
class RunFolder {
 public:
  /// Makes the folder.
  /// @param runs folder of all runs; made if missing
  /// @param recipe_name becomes part of the id
  /// @throw scan_cell_common::FileError if it cannot be made
  RunFolder(const std::filesystem::path& runs, const std::string& recipe_name);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::string& id() const { return id_; }
  const std::filesystem::path& path() const { return partial_; }  //!< until it is sealed

  /// Copies a file into the folder.
  /// @param name in the folder, may have folders of its own
  /// @throw scan_cell_common::FileError
  void add(const std::filesystem::path& file, const std::string& name) const;

  /// Writes run.json with the hash of every other file.
  /// @throw scan_cell_common::FileError
  void write(RunRecord& record) const;

  /// Brings everything to the disk and gives the folder its name. After that the folder is whole,
  /// even if the machine goes off.
  /// @return the run's folder
  /// @throw scan_cell_common::FileError
  std::filesystem::path seal();

 private:
  std::filesystem::path runs_;
  std::string id_;
  std::filesystem::path partial_;
  bool sealed_ = false;
};

/// Entries of every file below a run's folder, except run.json and the page that is made from it.
/// @throw scan_cell_common::FileError
std::map<std::string, FileEntry> files_of(const std::filesystem::path& folder);

/// Checks that a run's files are as they were when it was sealed.
/// @throw scan_cell_common::UnusableInput naming the first that is missing, changed or new
void check_files(const std::filesystem::path& folder, const RunRecord& record);

}  // namespace part_recipes
