// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "parts/scan.h"
#include "tool_path_stretcher/verdict.h"

namespace cases {

/// A reference, an object, and the full truth about their relation.
struct Case {
  std::string name;
  Part reference;
  Part object;  //!< the same part, or a wrong one
  Deformation deformation = none();
  Similarity similarity;
  Scan reference_scan;
  Scan object_scan;
  tool_path_stretcher::Reason expected = tool_path_stretcher::Reason::kAccepted;
  std::optional<tool_path_stretcher::Reason> also = {};  //!< also allowed by the geometry
  double stand_off = 0;    //!< [m] of the tool from the surface, along its normal
  bool own_image = false;  //!< the path is symmetric: waypoints may change places

  bool is_right(tool_path_stretcher::Reason reason) const {
    return reason == expected || reason == also;
  }
};

/// The data of a case: two clouds, the given path and the true path.
struct Scene {
  Points reference;
  Points object;
  ToolPath path;
  ToolPath truth;
};
Scene scene_of(const Case& each);

/// The path to compare an adapted path with: the truth, or for a symmetric path, the nearest
/// waypoints of the truth.
ToolPath truth_beside(const ToolPath& path, const Scene& scene, const Case& each);

/// All cases of the benchmark, including two real parts if `data` has them.
/// @param data folder with parts/<name>/part.stl and toolpath.yaml; empty: none
std::vector<Case> all_cases(const std::string& data);

/// Adds cases with kinds of parts, scans and combinations that the stretcher was not developed on.
void add_harder(std::vector<Case>& all);

/// Adds cases with a partial reference, object or both, with the path in the part that both show.
void add_partial(std::vector<Case>& all);

}  // namespace cases
