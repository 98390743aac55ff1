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
  std::string name;    //!< its path
  std::string sha256;  //!< of its bytes, in lower case hexadecimal digits
  std::string units;   //!< of its lengths: m, mm or inch
};

/// The record of a file as it is now.
/// @throw scan_cell_common::FileError if it cannot be read
FileRecord record_of(const std::string& file, const std::string& units);

/// What a report says that others go by, and by which it can be told whose report it is.
struct ReportedVerdict {
  bool accepted = false;                 //!< whether there is a path
  std::string reason;                    //!< as to_string(Reason) writes it
  std::string message;                   //!< for a person
  std::vector<std::size_t> waypoints;    //!< concerned, counted over all segments
  std::vector<Similarity> similarities;  //!< best first; empty where it did not come to that

  std::optional<FileRecord> reference;  //!< none where the run was not from files
  std::optional<FileRecord> object;     //!< the same
  std::optional<FileRecord> path;       //!< the same
  std::optional<FileRecord> output;     //!< the same
  std::size_t reference_points = 0;     //!< after reduction; 0: not known
  std::size_t object_points = 0;        //!< the same
  std::size_t waypoints_given = 0;      //!< of the path on the reference; 0: not known
  std::vector<double> displacements;    //!< [m] a waypoint; empty where it did not come to that
  std::vector<double> expected_errors;  //!< [m] a waypoint: of its place, along the normal and the
                                        //!< surface together; NaN: not known
  std::vector<std::size_t> in_air;      //!< waypoints, counted over all segments
};

/// Reads a report of stretch (docs/tool_path_stretcher.md).
/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the file is no report
ReportedVerdict load_report(const std::string& path);

}  // namespace tool_path_stretcher
