// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scanner_views/draws.h"
#include "scanner_views/parts/mesh_builder.h"
#include "tool_path_stretcher/tool_path.h"

/// Parts, a scanner that scans them, and how methods perform on its scans.
namespace scanner_views {

/// A part as a mesh, standing on z = 0 with its working side up.
struct ViewPart {
  std::string name;
  Mesh mesh;                                //!< [m] closed, or an open sheet
  bool symmetric = false;                   //!< coincides with itself in another pose
  tool_path_stretcher::ToolPath path = {};  //!< a real path; empty: a random one
};

/// Generated parts with random dimensions.
/// @param draws the same draws give the same parts
std::vector<ViewPart> plate_parts(Draws& draws);      //!< milled and cast: flat faces and walls
std::vector<ViewPart> profile_parts(Draws& draws);    //!< extruded
std::vector<ViewPart> curved_parts(Draws& draws);     //!< sheets, pipes, blades
std::vector<ViewPart> symmetric_parts(Draws& draws);  //!< symmetric

/// Large sheets with openings, with paths that cross the openings, pass the rim, and approach and
/// leave through the air.
std::vector<ViewPart> sanded_sheets(Draws& draws);

/// Parts from files, if `data` has them.
/// @param data folder with parts/; empty: none
std::vector<ViewPart> real_parts(const std::string& data);

/// The plate_parts() bracket with one rib elsewhere: another variant of the part.
ViewPart bracket_variant(Draws& draws);

}  // namespace scanner_views
