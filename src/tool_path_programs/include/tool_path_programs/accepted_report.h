// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool_path_programs {

/// What a program takes from the report that `stretch` wrote with the path.
struct AcceptedReport {
  std::vector<std::string> comments;  //!< lines for the program: verdict, files, hashes
  std::vector<std::size_t> in_air;    //!< waypoints not in contact, counted over all segments
  // SHA-256 of files; empty: not in the report
  std::string proven_path;        //!< path on the reference, combined with the edits by hand
  std::string scanner;            //!< scanner model used for the scan
  std::string cell;               //!< cell file used for the scan
  std::optional<double> scanned;  //!< [s] since 1970, of the object; none: not in the report
};

/// Reads a report and checks that it accepted this path.
/// @param report, path files
/// @throw scan_cell_common::FileError if a file cannot be read
/// @throw scan_cell_common::UnusableInput if the file is not a report
/// @throw scan_cell_common::Refused if the report refuses the path, or accepted a path with other
/// bytes
AcceptedReport accepted_report(const std::string& report, const std::string& path);

}  // namespace tool_path_programs
