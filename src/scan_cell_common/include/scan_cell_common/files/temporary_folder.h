// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace scan_cell_common {

/// A folder for temporary files, removed with this object.
class TemporaryFolder {
 public:
  /// @param name start of the folder's name, such as the tool's name
  /// @throw FileError if the folder cannot be created
  explicit TemporaryFolder(const std::string& name);
  ~TemporaryFolder();

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }  //!< of the folder
  /// Path of a file in it.
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace scan_cell_common
