// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "scan_cell_common/net/descriptor.h"

namespace part_recipes {

/// Lock on a folder. Many share it while they use a file in the folder, such as a database; one
/// alone holds it while it replaces that file. The lock ends with the process. The folder only
/// needs to be readable.
class FolderLock {
 public:
  enum class Kind { kShared, kAlone };

  /// Waits up to 60 s.
  /// @throw scan_cell_common::FileError if the folder cannot be read
  /// @throw scan_cell_common::Refused if another process holds it that long
  FolderLock(const std::filesystem::path& folder, Kind kind);

 private:
  scan_cell_common::Descriptor descriptor_;
};

}  // namespace part_recipes
