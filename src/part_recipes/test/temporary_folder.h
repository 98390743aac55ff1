// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scan_cell_common/files/temporary_folder.h"

namespace part_recipes {

/// A folder that is removed at the end, even if a test took away its permissions.
class TemporaryFolder : public scan_cell_common::TemporaryFolder {
 public:
  TemporaryFolder() : scan_cell_common::TemporaryFolder("part_recipes") {}
  ~TemporaryFolder();
};

/// From then on permissions apply to this process, even for root.
void drop_capabilities();

}  // namespace part_recipes
