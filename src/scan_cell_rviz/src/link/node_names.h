// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace scan_cell_rviz {

/// Names of the cell's nodes and topics.
struct NodeNames {
  std::string recipes = "/part_recipes";      //!< node
  std::string robot = "/c4g_driver";          //!< node
  std::string trigger = "/laser_trigger";     //!< node
  std::string camera = "/camera";             //!< node
  std::string cell = "/scan_cell";            //!< node
  std::string frames = "/calibrated_frames";  //!< node whose parameters name the calibration
  std::string joints = "/joint_states";       //!< topic
};

}  // namespace scan_cell_rviz
