// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "tool_path_stretcher/similarity.h"
#include "tool_paths/path_conventions.h"

namespace part_recipes {

/// A tool path on the reference, and its adaptation to the object.
struct PathPair {
  tool_paths::ToolPathFile reference;               //!< [m]
  std::optional<tool_paths::ToolPathFile> adapted;  //!< [m]; none: refused
};

/// Turn [rad] of the tool at each waypoint beyond that of the part: between the orientation that
/// the similarity's rotation would give it and its actual one. For paths that hold only the tool's
/// axis, it is the angle between the axes.
/// @return none if the paths have no orientations, or different numbers of waypoints
std::optional<std::vector<double>> turns_of(const PathPair& paths,
                                            const tool_path_stretcher::Similarity& similarity);

/// JSON for a page: names of the segments, each waypoint's segment, positions [m] on the reference,
/// after the similarity, and on the object, and turns [rad]; null where not known.
std::string to_json(const PathPair& paths,
                    const std::optional<tool_path_stretcher::Similarity>& similarity);

}  // namespace part_recipes
