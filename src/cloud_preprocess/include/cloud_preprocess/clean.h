// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cloud_preprocess/cloud_edits.h"
#include "cloud_preprocess/floor_removal.h"
#include "cloud_preprocess/grid_reduction.h"
#include "cloud_preprocess/object_isolation.h"
#include "cloud_preprocess/outlier_removal.h"

namespace scan_cell_common {
class YamlEntry;
}  // namespace scan_cell_common

namespace cloud_preprocess {

/// The whole chain. Floor, outliers and isolation do nothing where they are not automatic and have
/// no limits.
struct CleanParameters {
  std::vector<CloudEdit> edits;                           //!< by hand, before all stages
  FloorParameters floor;                                  //!< of the first stage
  OutlierParameters outliers;                             //!< of the second stage
  IsolationParameters isolate;                            //!< of the third stage
  std::optional<GridParameters> grid = GridParameters{};  //!< none: the cloud is not reduced
};

/// Of all stages, each in a group of its name.
void describe(scan_cell_common::ParameterTable& table, CleanParameters& parameters);

/// Reads them from YAML: maps `floor`, `outliers`, `isolate` and `grid` with the parameters of the
/// nodelets of these names; `grid: false` leaves the grid out; `edits` is a list as read_edits()
/// takes it. What is not given keeps its default, also where nothing is.
/// @throw scan_cell_common::FileError, UnusableInput or InvalidParameter, naming the entry
CleanParameters load_clean_parameters(const std::string& path);
/// As load_clean_parameters().
CleanParameters read_clean_parameters(
    const scan_cell_common::YamlEntry& root);  //!< as load_clean_parameters()

/// The maps `floor`, `outliers` and `isolate`, as read_clean_parameters() takes them, each with
/// what is not as it is by default.
std::string stages_yaml(const CleanParameters& parameters);

/// Runs edits (if there are any), floor, outliers, isolation and grid, one after the other.
/// @param reports one a stage, also of the stage that throws
/// @throw scan_cell_common::InvalidParameter before anything is done
/// @throw scan_cell_common::UnusableInput from the stage that leaves nothing
Cloud clean(Cloud cloud, const CleanParameters& parameters, std::vector<StageReport>& reports);

/// The same, and the points know where they come from.
void clean(TracedCloud& cloud, const CleanParameters& parameters,
           std::vector<StageReport>& reports);

/// The same, and each object that the stage isolate found is cleaned, too.
/// @param[out] objects along `isolate/axis`; the one that is asked for is among them
void clean(TracedCloud& cloud, const CleanParameters& parameters, std::vector<StageReport>& reports,
           std::vector<TracedCloud>& objects);

}  // namespace cloud_preprocess
