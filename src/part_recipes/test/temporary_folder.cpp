// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_folder.h"

#include <linux/capability.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <stdexcept>

namespace part_recipes {

TemporaryFolder::~TemporaryFolder() {
  std::error_code failure;
  std::filesystem::permissions(path(), std::filesystem::perms::owner_all, failure);
}

void drop_capabilities() {
  __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3] = {};
  if (syscall(SYS_capset, &header, none) != 0) throw std::runtime_error("capabilities stay");
}

}  // namespace part_recipes
