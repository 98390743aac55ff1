// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "history/remember.h"

#include "history/history.h"
#include "scan_cell_common/errors/errors.h"

namespace part_recipes {

void remember(EndedRun& run) {
  try {
    History(run.folder.parent_path()).add(run.folder);
  } catch (const scan_cell_common::Error& error) {
    run.warn(error.what());
  }
}

}  // namespace part_recipes
