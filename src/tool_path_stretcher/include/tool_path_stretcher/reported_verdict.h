// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tool_path_stretcher/similarity.h"

namespace tool_path_stretcher {

/// A file that a run read or wrote.
struct FileRecord {
  std::string name;    //!< path of the file
  std::string sha256;  //!< of its contents, lower-case hexadecimal
  std::string units;   //!< length unit: m, mm or inch
};

/// Records a file as it is now.
/// @throw scan_cell_common::FileError if it cannot be read
FileRecord record_of(const std::string& file, const std::string& units);

/// The parts of a report that other programs use, and those that identify the run it belongs to.
struct ReportedVerdict {
  bool accepted = false;                 //!< whether there is a path
  std::string reason;                    //!< as written by to_string(Reason)
  std::string message;                   //!< for a person
  std::vector<std::size_t> waypoints;    //!< concerned, counted over all segments
  std::vector<Similarity> similarities;  //!< best first; empty if the run did not get that far

  std::optional<FileRecord> reference;  //!< none if the run did not read files
  std::optional<FileRecord> object;     //!< the same
  std::optional<FileRecord> path;       //!< the same
  std::optional<FileRecord> output;     //!< the same
  std::size_t reference_points = 0;     //!< after reduction; 0: unknown
  std::size_t object_points = 0;        //!< the same
  std::size_t waypoints_given = 0;      //!< of the path on the reference; 0: unknown
  std::vector<double> displacements;    //!< [m] per waypoint; empty if the run did not get that far
  std::vector<double> expected_errors;  //!< [m] per waypoint: position, normal and tangential
                                        //!< combined; NaN: unknown
  std::vector<std::size_t> in_air;      //!< waypoints, counted over all segments
};

/// Reads a report of stretch (docs/tool_path_stretcher.md).
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the file is not a report
ReportedVerdict load_report(const std::string& path);

}  // namespace tool_path_stretcher
