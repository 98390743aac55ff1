// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>

#include "record/run_record.h"

namespace part_recipes {

/// A text of a run that has a column of its own.
struct TextColumn {
  const char* name;  //!< of the column and in files
  std::string RunRecord::*member;
};

/// What a figure is measured in.
enum class Quantity { kRatio, kLength, kAngle };

/// A figure of a run that has a column of its own.
struct FigureColumn {
  const char* name;  //!< of the column and in files
  std::optional<double> RunFigures::*member;
  Quantity quantity;
};

/// All of them, in the order of the columns.
inline constexpr std::array<TextColumn, 13> kTextColumns = {{
    {"id", &RunRecord::id},
    {"recipe", &RunRecord::recipe_name},
    {"recipe_folder", &RunRecord::recipe_folder},
    {"recipe_sha256", &RunRecord::recipe_sha256},
    {"started", &RunRecord::started},
    {"ended", &RunRecord::ended},
    {"host", &RunRecord::host},
    {"version", &RunRecord::version},
    {"reason", &RunRecord::reason},
    {"message", &RunRecord::message},
    {"scan_units", &RunRecord::scan_units},
    {"again_of", &RunRecord::again_of},
    {"note", &RunRecord::note},
}};
inline constexpr std::array<FigureColumn, 9> kFigureColumns = {{
    {"scale", &RunFigures::scale, Quantity::kRatio},
    {"rms", &RunFigures::rms, Quantity::kLength},
    {"largest_displacement", &RunFigures::largest_displacement, Quantity::kLength},
    {"expected_error_normal", &RunFigures::expected_error_normal, Quantity::kLength},
    {"expected_error_tangential", &RunFigures::expected_error_tangential, Quantity::kLength},
    {"expected_error_orientation", &RunFigures::expected_error_orientation, Quantity::kAngle},
    {"deviation_rms", &RunFigures::deviation_rms, Quantity::kLength},
    {"deviation_min", &RunFigures::deviation_min, Quantity::kLength},
    {"deviation_max", &RunFigures::deviation_max, Quantity::kLength},
}};

}  // namespace part_recipes
