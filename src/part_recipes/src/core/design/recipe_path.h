// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "path_design/path_parameters.h"
#include "recipe/recipe.h"
#include "run/calls/tool_call.h"
#include "scan_cell_common/files/temporary_folder.h"
#include "tool_paths/tool_path.h"

namespace part_recipes {

/// The ways of the tool path (docs/making_a_path.md).
enum class PathWay { kEdge, kSlices, kPicks };

/// An option of a way, for a person who sets it.
struct PathOption {
  std::string name;                //!< as ToolOptions have it
  std::string unit;                //!< such as m; empty: none
  std::string value;               //!< default, as the tool takes it; empty: none
  std::string range;               //!< in words
  std::vector<std::string> words;  //!< of a choice; empty: it is none
  std::string meaning;
};

/// All options of a way, in their order.
std::vector<PathOption> options_of(PathWay way);

/// How the options describe the view of the reference: from, leaf and crease_angle.
/// @throw scan_cell_common::InvalidParameter if one of them is not allowed
PathParameters surface_parameters(const ToolOptions& options);

/// A path made on a recipe's reference by the tool path, in a folder of its own.
class RecipePath {
 public:
  /// @param options of the way, as options_of() names them
  /// @param picks [m] on the reference; only for kPicks
  /// @param stop asked a few times a second; if true, the tool is told to end
  /// @throw scan_cell_common::InvalidParameter if the way has no such option, or a value is not a
  /// number
  /// @throw scan_cell_common::Refused with the tool's reason
  /// @throw scan_cell_common::UnusableInput likewise; scan_cell_common::FileError
  RecipePath(const Recipe& recipe, PathWay way, const ToolOptions& options,
             const tool_paths::Points& picks, const Stop& stop);

  const tool_paths::ToolPath& path() const { return path_; }        //!< [m] on the reference
  const std::vector<std::string>& notes() const { return notes_; }  //!< what was left out, bridged

  /// Makes RECIPES/NAME as a copy of the recipe with this path. Where the recipe's work and
  /// programs name the side of the z axis, it becomes the path's. The recipe counts as made, not
  /// proven.
  /// @throw as make_recipe()
  Recipe save_as(const std::filesystem::path& recipes, const std::string& name) const;

 private:
  Recipe recipe_;
  scan_cell_common::TemporaryFolder folder_;
  std::string waypoint_z_;  // as used for the path
  tool_paths::ToolPath path_;
  std::vector<std::string> notes_;
};

}  // namespace part_recipes
