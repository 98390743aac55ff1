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

/// Parameters of the whole chain. Floor, outliers and isolation do nothing if they are not
/// automatic and have no limits.
struct CleanParameters {
  std::vector<CloudEdit> edits;                           //!< by hand, before all stages
  FloorParameters floor;                                  //!< of the first stage
  OutlierParameters outliers;                             //!< of the second stage
  IsolationParameters isolate;                            //!< of the third stage
  std::optional<GridParameters> grid = GridParameters{};  //!< none: the cloud is not reduced
};

/// Describes the parameters of all stages, each stage in a group with its name.
void describe(scan_cell_common::ParameterTable& table, CleanParameters& parameters);

/// Reads the parameters from YAML. The maps `floor`, `outliers`, `isolate` and `grid` have the
/// parameters of the nodelets of these names; `grid: false` leaves the grid out; `edits` is a list
/// for read_edits(). Anything not given keeps its default; the file may be empty.
/// @throw scan_cell_common::FileError, UnusableInput or InvalidParameter, naming the entry
CleanParameters load_clean_parameters(const std::string& path);
/// As load_clean_parameters().
CleanParameters read_clean_parameters(const scan_cell_common::YamlEntry& root);

/// The maps `floor`, `outliers` and `isolate` for read_clean_parameters(), each with the parameters
/// that differ from their defaults.
std::string stages_yaml(const CleanParameters& parameters);

/// Runs edits (if any), floor, outliers, isolation and grid, one after the other.
/// @param reports one per stage, including the stage that throws
/// @throw scan_cell_common::InvalidParameter before anything is done
/// @throw scan_cell_common::UnusableInput from the stage that leaves nothing
Cloud clean(Cloud cloud, const CleanParameters& parameters, std::vector<StageReport>& reports);

/// The same, with the source of each point.
void clean(TracedCloud& cloud, const CleanParameters& parameters,
           std::vector<StageReport>& reports);

/// The same, and also cleans each object that the stage isolate found.
/// @param[out] objects along `isolate/axis`, including the requested one
void clean(TracedCloud& cloud, const CleanParameters& parameters, std::vector<StageReport>& reports,
           std::vector<TracedCloud>& objects);

}  // namespace cloud_preprocess
