// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <filesystem>

#include "view/run_view.h"

namespace part_recipes {

/// Shows one run in rviz, on latched topics: ~raw (the scan as it came; a large one is thinned),
/// ~deviation (the scanned object; its points carry the field deviation [m] where it is known, and
/// its colour), ~path (the proven path, where the part lies), ~adapted_path, ~concerned (waypoints
/// that the verdict is about), ~unseen (waypoints that the scan could not see, and the obstacles),
/// ~expected (how far off the adapted path may be, and the tool's axes) and ~signs (the verdict in
/// words, the scale of the colours, plus and minus). What a run does not have is shown empty.
class RunDisplay {
 public:
  explicit RunDisplay(ros::NodeHandle node);

  /// Publishes nothing if the run is already shown: runs do not change.
  /// @throw scan_cell_common::Error from the readers of its files
  void show(const std::filesystem::path& run, const RunView& view);

 private:
  std::filesystem::path shown_;  // empty: none
  ros::Publisher raw_, deviation_, path_, adapted_, concerned_, unseen_, expected_, signs_;
};

}  // namespace part_recipes
