// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "scanner_views/draws.h"
#include "scanner_views/parts/mesh_builder.h"
#include "tool_path_stretcher/tool_path.h"

/// Parts, a scanner that looks at them, and how methods fare that are given what it sees.
namespace scanner_views {

/// A part as a mesh, as it stands on z = 0 with the side up that is worked on.
struct ViewPart {
  std::string name;
  Mesh mesh;                                //!< [m] closed, or an open sheet
  bool symmetric = false;                   //!< its own image in another pose
  tool_path_stretcher::ToolPath path = {};  //!< a real one; empty: one is drawn
};

/// Of the kinds of parts that the project generates, with dimensions that are drawn.
/// @param draws the same draws give the same parts
std::vector<ViewPart> plate_parts(Draws& draws);      //!< milled and cast: flat faces and walls
std::vector<ViewPart> profile_parts(Draws& draws);    //!< extruded
std::vector<ViewPart> curved_parts(Draws& draws);     //!< sheets, pipes, blades
std::vector<ViewPart> symmetric_parts(Draws& draws);  //!< their own images

/// Large sheets with openings, and paths that lead on across them, past the rim, and to and from
/// the sheet through the air.
std::vector<ViewPart> sanded_sheets(Draws& draws);

/// Those of files, where `data` holds them.
/// @param data folder with parts/; empty: none
std::vector<ViewPart> real_parts(const std::string& data);

/// The plate_parts() bracket with one rib elsewhere: another variant of the part.
ViewPart bracket_variant(Draws& draws);

}  // namespace scanner_views
