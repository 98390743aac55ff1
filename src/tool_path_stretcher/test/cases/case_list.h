// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "parts/scan.h"
#include "tool_path_stretcher/verdict.h"

namespace cases {

/// A reference, an object, and all that is known of how the one lies to the other.
struct Case {
  std::string name;
  Part reference;
  Part object;  //!< the same part, or a wrong one
  Deformation deformation = none();
  Similarity similarity;
  Scan reference_scan;
  Scan object_scan;
  tool_path_stretcher::Reason expected = tool_path_stretcher::Reason::kAccepted;
  std::optional<tool_path_stretcher::Reason> also = {};  //!< that geometry allows as well
  double stand_off = 0;    //!< [m] of the tool from the surface, along its normal
  bool own_image = false;  //!< the path is its own image: waypoints may change places

  bool is_right(tool_path_stretcher::Reason reason) const {
    return reason == expected || reason == also;
  }
};

/// What the case is made of: two clouds, the path that is given, and where it comes to lie.
struct Scene {
  Points reference;
  Points object;
  ToolPath path;
  ToolPath truth;
};
Scene scene_of(const Case& each);

/// What an adapted path is compared with: the truth, or of a path that is its own image the truth's
/// nearest waypoints.
ToolPath truth_beside(const ToolPath& path, const Scene& scene, const Case& each);

/// All cases of the benchmark. Two real parts are among them where `data` holds them.
/// @param data folder with parts/<name>/part.stl and toolpath.yaml; empty: none
std::vector<Case> all_cases(const std::string& data);

/// Those with kinds of parts, scans and combinations that the stretcher was not developed on.
void add_harder(std::vector<Case>& all);

/// Those of which the reference, the object or both are partial, with the path in what both have.
void add_partial(std::vector<Case>& all);

}  // namespace cases
