// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "temporary_folder.h"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace part_recipes {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "part_recipes_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code failure;
  std::filesystem::permissions(path_, std::filesystem::perms::owner_all, failure);
  std::filesystem::remove_all(path_, failure);
}

}  // namespace part_recipes
