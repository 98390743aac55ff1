// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "record/run_record.h"

namespace part_recipes {

/// A figure of a run beside its limit.
struct JudgedFigure {
  std::string name;
  std::string value;  //!< with its unit
  std::string limit;  //!< such as "at most 5 mm"; empty: none, or not known
};

/// The figures with the limits of this run: the recipe's values for stretch or else the defaults,
/// and the recipe's tolerance of deviations. Shares of the object and of the reference follow, as
/// in the report. The additional allowance for surfaces that are sparser than the limit
/// (docs/tool_path_stretcher.md) is not included.
/// @param run folder
/// @param texts of the figures by name, as texts_of() gives them
std::vector<JudgedFigure> judged_figures(
    const std::filesystem::path& run, const RunRecord& record,
    const std::vector<std::pair<std::string, std::string>>& texts);

}  // namespace part_recipes
