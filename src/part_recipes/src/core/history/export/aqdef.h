// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "history/history_rows.h"

namespace part_recipes {

/// The runs in the Q-DAS ASCII transfer format (AQDEF), as a file with description and values
/// (.dfq). Each recipe is a part; its characteristics are scale, rms [mm] and the deviation of each
/// place [mm] with the tolerance of the recipe's last run. For the K fields see
/// docs/run_history.md. Values of a run that was not accepted have attribute 129 (invalid); unknown
/// values have 256 (deleted on reading). Runs that repeat another one are left out. The text is
/// UTF-8, with a byte order mark unless it is plain ASCII; lines end with CR LF.
std::string to_aqdef(const std::vector<HistoryRun>& runs);

}  // namespace part_recipes
