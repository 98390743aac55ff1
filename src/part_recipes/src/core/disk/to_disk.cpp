// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "disk/to_disk.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

void to_disk(const std::filesystem::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool ok = descriptor >= 0 && fsync(descriptor) == 0;
  const std::string reason = std::strerror(errno);
  if (descriptor >= 0) close(descriptor);
  if (!ok) throw scan_cell_common::FileError(path.string(), reason, "check the disk");
}

void throw_file_error(const std::filesystem::filesystem_error& error) {
  throw scan_cell_common::FileError(error.path1().string(), error.code().message(),
                                    "check the folder, its permissions and the disk");
}

}  // namespace part_recipes
