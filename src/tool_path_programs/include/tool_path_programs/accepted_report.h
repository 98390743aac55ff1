// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool_path_programs {

/// What a program needs of the report that stretch wrote with its path.
struct AcceptedReport {
  std::vector<std::string> comments;  //!< lines for the program: verdict, files, hashes
  std::vector<std::size_t> in_air;    //!< waypoints, counted over all segments
  // SHA-256 of files; empty: the report does not say
  std::string proven_path;        //!< of the path on the reference, and of what was edited by hand
  std::string scanner;            //!< of the scanner model that the scan was made with
  std::string cell;               //!< of the cell file that it was made with
  std::optional<double> scanned;  //!< [s] since 1970, of the object; none: the report does not say
};

/// Reads a report, and makes sure that the path is the one that it accepted.
/// @param report, path files
/// @throw scan_cell_common::FileError if one cannot be read
/// @throw scan_cell_common::UnusableInput if the report is none
/// @throw scan_cell_common::Refused if it refuses, or the path's bytes are not those it accepted
AcceptedReport accepted_report(const std::string& report, const std::string& path);

}  // namespace tool_path_programs
