// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool_path_stretcher/stretch_parameters.h"
#include "tool_path_stretcher/surface.h"

namespace tool_path_stretcher {

/// A thing in a scan that a reference explains.
struct FoundPart {
  Points laid;                         //!< [m] the reference's points in the found pose
  std::vector<std::size_t> explained;  //!< indices of scan points, ascending
};

/// The parts of a scan that a reference explains.
struct PartsInScan {
  std::vector<FoundPart> parts;  //!< one: the part; several: they look alike
  std::string why_none;  //!< why the largest thing is not the part; empty if a part was found
};

/// Searches a scan of several things for the reference's part, with the registration and the
/// verdicts of stretch(). Tries each thing alone, largest first; if none fits, all of them
/// together. Pieces torn off the part, or taken for separate things, are found by where the
/// reference lies.
/// @param scan [m] without the floor
/// @param things indices of the scan points of each thing
/// @throw scan_cell_common::UnusableInput if the scan is unusable
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense
PartsInScan parts_in_scan(const Surface& reference, const Points& scan,
                          const std::vector<std::vector<std::size_t>>& things,
                          const StretchParameters& parameters);

}  // namespace tool_path_stretcher
