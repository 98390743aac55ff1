// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "scan_cell_common/net/descriptor.h"

namespace part_recipes {

/// Many share the lock while they use what lies in a folder, as a database, and one alone has it
/// while it puts another in its place. Ends with the process. It asks nothing of the folder but
/// that it can be read.
class FolderLock {
 public:
  enum class Kind { kShared, kAlone };

  /// Waits up to 60 s.
  /// @throw scan_cell_common::FileError if the folder cannot be read
  /// @throw scan_cell_common::Refused if another has it that long
  FolderLock(const std::filesystem::path& folder, Kind kind);

 private:
  scan_cell_common::Descriptor descriptor_;
};

}  // namespace part_recipes
