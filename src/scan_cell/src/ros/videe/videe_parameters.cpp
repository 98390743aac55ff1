// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "videe/videe_parameters.h"

#include <filesystem>

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell {

void describe(scan_cell_common::ParameterTable& table, VideeCalibrationParameters& parameters) {
  table.add("poses", parameters.poses,
            "file of taught poses (scan_calibration.md); empty: calibration is refused");
  table.add("sessions", parameters.sessions,
            "folder in which each calibration makes a session folder named by the time");
  table.add("output", parameters.output, "scanner model to write; empty: calibrations only record");
  table.add("board_columns", parameters.board_columns, {3, 200},
            "inner corners of the board along its x");
  table.add("board_rows", parameters.board_rows, {3, 200},
            "inner corners of the board along its y");
  table.add("square_size", parameters.square_size, {0.0001, 1, "m"}, "of the board");
  table.add("lasers", parameters.lasers, {0, 3},
            "bit mask: 1 laser_0, 2 laser_1, 3 both in turn, 0 none: the camera alone");
  table.add("scanner", parameters.scanner,
            "existing scanner model, used for what is not calibrated again "
            "(scan_calibration.md); empty: none");
  table.add("lasers_alone", parameters.lasers_alone,
            "the camera and its pose on the flange are taken from `scanner` too");
  table.add("board_exposure", parameters.board_exposure, {1e-6, 0.4, "s"},
            "of the image of the board, lasers off");
  table.add("line_exposure", parameters.line_exposure, {1e-6, 0.4, "s"},
            "of the images of a laser's line");
}

void describe(scan_cell_common::ParameterTable& table, VideeParameters& parameters) {
  table.add("address", parameters.server.address, "interface to listen on");
  table.add("port", parameters.server.port, {1, 65535}, "TCP port");
  table.add("client", parameters.server.client,
            "the only client address that is answered; others are disconnected without an answer; "
            "empty: any that reaches the port");
  table.add("idle_time", parameters.server.idle_time, {1, 86400, "s"},
            "time in which a whole command must arrive");
  table.require("program", parameters.program,
                "scan program (YAML): its frame is used, and the speed, rate, laser and camera of "
                "its first pass");
  table.add("image_folder", parameters.image_folder,
            "folder in which `GRAB_IMAGE` saves its images; must exist");
  table.add("cloud_folder", parameters.cloud_folder,
            "folder in which `STOP_SCAN` saves its clouds; must exist");
  for (const auto& [name, folder] : {std::pair("image_folder", parameters.image_folder),
                                     std::pair("cloud_folder", parameters.cloud_folder)}) {
    if (!std::filesystem::is_directory(folder))
      table.refuse(name, "'" + folder + "'", "give a folder that exists");
  }
  table.add("scan", parameters.scan, "scan action");
  table.add("grab_image", parameters.grab_image, "service");
  table.add("calibrate", parameters.calibrate, "calibration action");
  table.add("state", parameters.state,
            "topic to which `videe_node` listens, so that the cell notices when it dies");
  table.add("triangulation", parameters.triangulation,
            "node on whose machine the files of large clouds lie");
  table.group("calibration", parameters.calibration);
  table.add(
      "call_timeout", parameters.call_timeout, {0.1, 60, "s"},
      "longest wait for an action to accept a goal; `GRAB_IMAGE` may take four times as long");
}

}  // namespace scan_cell
