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
  Points laid;                         //!< [m] the reference's points where they come to lie
  std::vector<std::size_t> explained;  //!< points of the scan, in rising order
};

/// What of a scan a reference explains.
struct PartsInScan {
  std::vector<FoundPart> parts;  //!< one: that is the part; several: they look alike
  std::string why_none;          //!< of what comes nearest; empty unless there are none
};

/// Looks for the reference's part in a scan of several things, by the registration and the verdicts
/// of stretch(). Each thing is tried alone, the largest first, and then all of them as one; what
/// was torn off the part, or was taken for a thing of its own, is found where the reference lies.
/// @param scan [m] without the floor
/// @param things points of the scan that belong together, thing by thing
/// @throw scan_cell_common::UnusableInput if the scan is none
/// @throw scan_cell_common::InvalidParameter if the parameters make no sense
PartsInScan parts_in_scan(const Surface& reference, const Points& scan,
                          const std::vector<std::vector<std::size_t>>& things,
                          const StretchParameters& parameters);

}  // namespace tool_path_stretcher
