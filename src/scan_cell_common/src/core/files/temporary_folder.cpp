// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/temporary_folder.h"

#include <cstdlib>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder(const std::string& name) {
  std::error_code failure;
  std::string made = (fs::temp_directory_path(failure) / (name + "_XXXXXX")).string();
  if (failure || mkdtemp(made.data()) == nullptr)
    throw FileError(made, "cannot be created", "check the folder for temporary files");
  path_ = made;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code failure;
  fs::remove_all(path_, failure);
}

}  // namespace scan_cell_common
