// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tool_path_stretcher/reported_verdict.h"
#include "tool_path_stretcher/surface.h"
#include "tool_path_stretcher/tool_path.h"

namespace tool_path_stretcher {

/// The files to show in a picture; an empty name means none.
struct PictureFiles {
  std::string reference;
  std::string object;
  std::string path;
  std::string adapted;
};

/// @throw scan_cell_common::UnusableInput if the report is about other files
void check_same_files(const ReportedVerdict& verdict, const PictureFiles& files);

struct PictureInput {
  Surface reference;
  Surface object;
  ToolPath path;
  std::optional<ToolPath> adapted;  //!< none: the path as the similarity puts it
  ReportedVerdict verdict;
  bool overlay = false;     //!< the reference laid over the object; false: beside it
  double azimuth = -1.05;   //!< [rad] of the eye about z
  double elevation = 0.75;  //!< [rad] of the eye above the x-y plane
};

/// For reports that name no files (the action's): compares clouds and paths with the report's
/// figures.
/// @throw scan_cell_common::UnusableInput if they do not fit
void check_figures(const PictureInput& input);

/// Draws the reference with its path on the left, and the object on the right, rotated into the
/// reference's orientation. The object is coloured by its distance from the aligned reference, with
/// the path on it and lines between corresponding waypoints. Waypoints named by the verdict are
/// red, those in the air blue. As an overlay, the reference lies over the object where the
/// similarity puts it.
/// @throw scan_cell_common::UnusableInput if an overlay is asked for but no pose was found
/// @throw scan_cell_common::FileError if it cannot be written
void save_picture(const std::string& path, const PictureInput& input);

}  // namespace tool_path_stretcher
