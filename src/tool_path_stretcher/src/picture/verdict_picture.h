// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report.h"
#include "tool_path_stretcher/similarity.h"
#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// What a report says that can be shown, and by which it can be told whose report it is.
struct ReportedVerdict {
  bool accepted = false;
  std::string reason;
  std::string message;
  std::vector<std::size_t> waypoints;    //!< concerned, counted over all segments
  std::vector<Similarity> similarities;  //!< best first; empty where it did not come to that

  // None where the run was not from files
  std::optional<FileRecord> reference, object, path, output;
  std::size_t reference_points = 0;   //!< after reduction; 0: not known
  std::size_t object_points = 0;      //!< the same
  std::size_t waypoints_given = 0;    //!< of the path on the reference; 0: not known
  std::vector<double> displacements;  //!< [m] a waypoint; empty where it did not come to that
};

/// @throw scan_cell_common::FileError, scan_cell_common::UnusableInput if the file is no report
ReportedVerdict load_report(const std::string& path);

/// The files that a picture is to show; without a name: there is none.
struct PictureFiles {
  std::string reference;
  std::string object;
  std::string path;
  std::string adapted;
};

/// @throw scan_cell_common::UnusableInput if the report is about other files than these
void check_same_files(const ReportedVerdict& verdict, const PictureFiles& files);

struct PictureInput {
  Surface reference;
  Surface object;
  ToolPath path;
  std::optional<ToolPath> adapted;  //!< none: where the similarity puts the path
  ReportedVerdict verdict;
  double azimuth = -1.05;   //!< [rad] of the eye about z
  double elevation = 0.75;  //!< [rad] of the eye above the x-y plane
};

/// For reports that name no files (the action's): holds the clouds and paths against its figures.
/// @throw scan_cell_common::UnusableInput if they do not fit
void check_figures(const PictureInput& input);

/// Draws the reference with its path to the left, and the object to the right, turned as the
/// reference lies: coloured by its distance from the aligned reference, with the path on it and
/// lines between corresponding waypoints. Waypoints that the verdict names are red.
/// @throw scan_cell_common::FileError if it cannot be written
void save_picture(const std::string& path, const PictureInput& input);

}  // namespace tool_path_stretcher
