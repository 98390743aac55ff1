// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "parts/deformation.h"
#include "scanner_views/parts/part_list.h"
#include "scanner_views/parts/path_on_part.h"
#include "scanner_views/scanner/looking.h"
#include "scanner_views/scanner/surroundings.h"
#include "tool_path_stretcher/verdict.h"

namespace scanner_views {

using tool_path_stretcher::Reason;
using tool_path_stretcher::Similarity;

/// A part, what was done to it, and how it is scanned.
struct ViewCase {
  std::string family;
  std::string what;  //!< short description, follows the part's name
  ViewPart reference;
  ViewPart object;  //!< the same part, or a wrong one
  cases::Deformation deformation = cases::none();
  Similarity similarity;           //!< to where the object lies, z up
  bool reference_scanned = false;  //!< otherwise its mesh is the reference
  Viewing viewing = Viewing::kAboveOneLaser;
  Surroundings surroundings;
  double scattered = 0;  //!< share of stray points, anywhere around
  bool cleaned = false;  //!< by clean_cloud's core, before it is given to the methods
  /// From the scanned part to the cloud.
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  Reason expected = Reason::kAccepted;
  PathKind path = PathKind::kRaster;
  bool whole_path = false;  //!< includes unscanned places
  std::uint64_t seed = 1;

  std::string name() const { return object.name + ", " + what; }
};

/// The methods' input and the truth.
struct View {
  std::optional<pcl::PolygonMesh> reference_mesh;  //!< none: the scan is the reference
  ScanPoints reference_scan;
  ScanPoints object;
  ScanPoints scan;          //!< before cleaning; empty: not cleaned
  std::string not_cleaned;  //!< why cleaning gave no cloud
  ToolPath path;            //!< on the reference
  ToolPath truth;
  std::size_t scanned = 0;  //!< points of the object's scan before cleaning
};

View view_of(const ViewCase& each);

}  // namespace scanner_views
