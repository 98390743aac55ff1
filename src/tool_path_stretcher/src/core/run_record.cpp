// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "report.h"
#include "scan_cell_common/files/sha256.h"
#include "scan_cell_common/pose/units.h"

namespace tool_path_stretcher {
namespace {

std::string millimetres(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.3g} mm", 1e3 * metres) : "unknown";
}

/// Empty for a path without orientations.
std::string and_degrees(double radians) {
  using scan_cell_common::kDegree;
  return std::isfinite(radians) ? fmt::format(", {:.2g} deg in orientation", radians / kDegree)
                                : "";
}

}  // namespace

FileRecord record_of(const std::string& file, const std::string& units) {
  return {file, scan_cell_common::sha256_of_file(file), units};
}

double total_seconds(const StretchResult& result, const RunRecord& record) {
  return record.seconds_reading + result.seconds + record.seconds_writing;
}

QualitySummary summary_of(const std::vector<WaypointQuality>& quality) {
  QualitySummary summary;
  for (const WaypointQuality& each : quality) {
    if (each.in_air) {
      ++summary.in_air;
      continue;
    }
    ++(each.measured ? summary.measured : summary.inferred);
    summary.largest_displacement = std::fmax(summary.largest_displacement, each.displacement);
    summary.largest_expected_error_normal =
        std::fmax(summary.largest_expected_error_normal, each.expected_error_normal);
    summary.largest_expected_error_tangential =
        std::fmax(summary.largest_expected_error_tangential, each.expected_error_tangential);
    summary.largest_expected_error_orientation =
        std::fmax(summary.largest_expected_error_orientation, each.expected_error_orientation);
  }
  return summary;
}

std::string to_string(const QualitySummary& summary) {
  return fmt::format(
      "{} waypoints, {} measured and {} inferred, {} in the air, displaced by up to {}, expected "
      "error up to {} along the normal and {} along the surface{}",
      summary.measured + summary.inferred + summary.in_air, summary.measured, summary.inferred,
      summary.in_air, millimetres(summary.largest_displacement),
      millimetres(summary.largest_expected_error_normal),
      millimetres(summary.largest_expected_error_tangential),
      and_degrees(summary.largest_expected_error_orientation));
}

}  // namespace tool_path_stretcher
