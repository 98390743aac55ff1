// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scanner_views/draws.h"
#include "scanner_views/parts/mesh_builder.h"
#include "tool_path_stretcher/tool_path.h"

namespace scanner_views {

using tool_path_stretcher::ToolPath;

/// The kind of path on the top of a part.
enum class PathKind {
  kRaster,  //!< lines side by side
  kRim,     //!< once around, along the outline
  kWave,    //!< one line that winds along the part
};

/// A path on the part's surface as seen from straight above: z out of the part, x along the path.
/// It is split where the surface jumps or bends sharply.
ToolPath path_on(const Mesh& part, PathKind kind, Draws& draws);

/// The path without the waypoints for which `keep` is false, split there; runs of fewer than five
/// are dropped too.
template <class Keep>
ToolPath parted(const ToolPath& path, const Keep& keep) {
  constexpr std::size_t kFewest = 5;  // waypoints; chosen
  ToolPath result = path;
  result.segments.clear();
  for (const tool_path_stretcher::Segment& segment : path.segments) {
    tool_path_stretcher::Segment run{segment.name, {}};
    const auto end_run = [&] {
      if (run.waypoints.size() >= kFewest) result.segments.push_back(run);
      run.waypoints.clear();
    };
    for (const tool_path_stretcher::Waypoint& waypoint : segment.waypoints) {
      if (keep(waypoint)) {
        run.waypoints.push_back(waypoint);
      } else {
        end_run();
      }
    }
    end_run();
  }
  return result;
}

}  // namespace scanner_views
