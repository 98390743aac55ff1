// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan.h"
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
};

/// All cases of the benchmark. Two real parts are among them where `data` holds them.
/// @param data folder with parts/<name>/part.stl and toolpath.yaml; empty: none
std::vector<Case> all_cases(const std::string& data);

}  // namespace cases
