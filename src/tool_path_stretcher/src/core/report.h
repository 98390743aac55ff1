// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "tool_path_stretcher/reported_verdict.h"
#include "tool_path_stretcher/stretcher.h"
#include "tool_paths/path_conventions.h"

namespace tool_path_stretcher {

/// Data of a run besides its result.
struct RunRecord {
  std::optional<tool_paths::PathContents> path;  //!< as understood; none: it could not be read
  std::optional<FileRecord> reference, object, path_file, output;  //!< none: no files
  double seconds_reading = 0;
  double seconds_writing = 0;  //!< the adapted path
};

/// [s] reading, adapting and writing.
double total_seconds(const StretchResult& result, const RunRecord& record);

/// Summary of how the scan supports an adapted path: waypoint counts, and the largest figures of
/// the waypoints not in the air. NaN: unknown.
struct QualitySummary {
  std::size_t measured = 0;
  std::size_t inferred = 0;
  std::size_t in_air = 0;
  double largest_displacement = kUnknown;                //!< [m]
  double largest_expected_error_normal = kUnknown;       //!< [m]
  double largest_expected_error_tangential = kUnknown;   //!< [m]
  double largest_expected_error_orientation = kUnknown;  //!< [rad]
};

QualitySummary summary_of(const std::vector<WaypointQuality>& quality);

/// One line for a person.
std::string to_string(const QualitySummary& summary);

/// The report described in docs/tool_path_stretcher.md, as JSON text in SI units.
std::string report_to_json(const StretchResult& result, const RunRecord& record = {});

/// Writes the report, whole or not at all.
/// @throw scan_cell_common::FileError if it cannot be written
void save_report(const std::string& path, const StretchResult& result,
                 const RunRecord& record = {});

}  // namespace tool_path_stretcher
