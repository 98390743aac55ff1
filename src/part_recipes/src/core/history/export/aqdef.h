// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "history/history_rows.h"

namespace part_recipes {

/// The runs in the Q-DAS ASCII transfer format (AQDEF), as a file with description and values
/// (.dfq): a part for each recipe, and for each part the characteristics scale, rms [mm] and the
/// deviation of each place [mm] with the tolerance of the recipe's last run. K fields, see
/// docs/run_history.md. Values of a run that was not accepted have attribute 129 (invalid), those
/// that are not known 256 (deleted when they are read). Runs that repeat another one are left out.
/// UTF-8, with a byte order mark where it is not plain ASCII; lines end with CR LF.
std::string to_aqdef(const std::vector<HistoryRun>& runs);

}  // namespace part_recipes
