// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "videe/videe_server.h"

namespace scan_cell_common {
class ParameterTable;
}

namespace scan_cell {

/// Parameters of a calibration over ViDeE.
struct VideeCalibrationParameters {
  std::string poses;
  std::string sessions = "/tmp";
  std::string output;
  int board_columns = 15;
  int board_rows = 25;
  double square_size = 0.020;  //!< [m]
  int lasers = 3;              //!< bit mask
  std::string scanner;
  bool lasers_alone = false;
  double board_exposure = 0.05;  //!< [s]
  double line_exposure = 0.001;  //!< [s]
};

/// Parameters of videe_node.
struct VideeParameters {
  VideeServer::Options server;
  std::string program;
  std::string image_folder = "/tmp";
  std::string cloud_folder = "/tmp";
  std::string scan = "/scan_cell/scan";                //!< action
  std::string grab_image = "/scan_cell/grab_image";    //!< service
  std::string calibrate = "/scan_cell/calibrate";      //!< action
  std::string state = "/scan_cell/state";              //!< topic
  std::string triangulation = "/laser_triangulation";  //!< node
  VideeCalibrationParameters calibration;
  double call_timeout = 5.0;  //!< [s]
};

/// Adds each parameter with its range, unit and meaning.
void describe(scan_cell_common::ParameterTable& table, VideeParameters& parameters);

}  // namespace scan_cell
