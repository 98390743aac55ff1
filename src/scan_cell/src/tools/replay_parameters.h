// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "client/adaptation.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell {

/// Parameters of replay.
struct ReplayParameters {
  std::string bag;
  std::string scan_id;
  AdaptationFiles files;
  double speed = 4;
  double timeout = 60;   //!< [s]
  double patience = 10;  //!< [s]
  std::string binder = "/pose_frame_binder";
  std::string triangulation = "/laser_triangulation";
};

inline void describe(scan_cell_common::ParameterTable& table, ReplayParameters& parameters) {
  table.require("bag", parameters.bag, "recorded bag");
  table.add(
      "scan_id", parameters.scan_id,
      "which scan of the bag; none: the last complete one. One that ended early is replayed only "
      "if it is named");
  table.require("reference", parameters.files.reference, "clean cloud of the reference");
  table.require("path", parameters.files.path, "tool path on it");
  table.require("output", parameters.files.output, "folder for the results");
  table.add("speed", parameters.speed, {0.01, 1000}, "playback rate, as a multiple of real time");
  table.add("timeout", parameters.timeout, {1, 3600, "s"},
            "longest wait for a node, a cloud or the stretcher");
  table.add("patience", parameters.patience, {0.1, 600, "s"}, "longest wait for data that is late");
  table.add("binder", parameters.binder, "node with `~start` and `~finish`");
  table.add("triangulation", parameters.triangulation,
            "node with `~start`, `~finish` and `~cloud`");
}

}  // namespace scan_cell
