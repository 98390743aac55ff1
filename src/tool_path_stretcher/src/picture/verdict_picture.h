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
  bool overlay = false;     //!< the reference laid over the object; false: beside it
  double azimuth = -1.05;   //!< [rad] of the eye about z
  double elevation = 0.75;  //!< [rad] of the eye above the x-y plane
};

/// For reports that name no files (the action's): holds the clouds and paths against its figures.
/// @throw scan_cell_common::UnusableInput if they do not fit
void check_figures(const PictureInput& input);

/// Draws the reference with its path to the left, and the object to the right, turned as the
/// reference lies: coloured by its distance from the aligned reference, with the path on it and
/// lines between corresponding waypoints. Waypoints that the verdict names are red, those in the
/// air blue. As overlay the reference lies over the object, where the similarity puts it.
/// @throw scan_cell_common::UnusableInput for an overlay if no pose was found
/// @throw scan_cell_common::FileError if it cannot be written
void save_picture(const std::string& path, const PictureInput& input);

}  // namespace tool_path_stretcher
