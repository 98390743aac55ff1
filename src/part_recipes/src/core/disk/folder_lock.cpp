// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "disk/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "scan_cell_common/errors/errors.h"

namespace part_recipes {
namespace {

using Clock = std::chrono::steady_clock;
using scan_cell_common::FileError;
using scan_cell_common::Refused;

constexpr auto kPatience = std::chrono::seconds(60);      // to rebuild a history takes some seconds
constexpr auto kInterval = std::chrono::milliseconds(5);  // short beside a rebuild

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, Kind kind)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_.number() < 0)
    throw FileError(folder.string(), std::strerror(errno), "give the folder of the runs");
  const int operation = (kind == Kind::kAlone ? LOCK_EX : LOCK_SH) | LOCK_NB;
  const auto end = Clock::now() + kPatience;
  while (flock(descriptor_.number(), operation) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      throw FileError(folder.string(), std::strerror(errno), "keep the runs on a local disk");
    if (Clock::now() > end)
      throw Refused(folder.string(), "in use by another program",
                    "wait until it has ended and try again");
    std::this_thread::sleep_for(kInterval);
  }
}

}  // namespace part_recipes
