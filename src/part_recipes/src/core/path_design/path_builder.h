// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "path_design/designed_path.h"
#include "path_design/trace/stepping.h"

namespace part_recipes {

/// Adds traces to a path, as waypoints.
class PathBuilder {
 public:
  explicit PathBuilder(const PathParameters& parameters);

  /// @param name of the segment
  void add(const path_design::Trace& trace, const std::string& name);

  void note(const std::string& text) { result_.notes.push_back(text); }  //!< for a person

  /// @throw scan_cell_common::Refused if nothing was added
  /// @param what the thing that was looked for, such as "rows"
  DesignedPath finish(const std::string& what);

 private:
  path_design::Steps steps_;
  path_design::Pose pose_;
  double speed_;
  double min_length_;
  std::size_t left_out_ = 0;
  DesignedPath result_;
};

/// The widest hole that counts as filled [m].
double filled_width(const path_design::PartMesh& reference, const PathParameters& parameters);

}  // namespace part_recipes
