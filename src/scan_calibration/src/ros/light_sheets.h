// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <scan_cell_msgs/TriggerEvent.h>
#include <scan_cell_msgs/TriggerState.h>
#include <visualization_msgs/MarkerArray.h>

#include "scan_cell_common/scanner/scanner_model.h"
#include "teaching/light_sheet.h"

namespace scan_calibration {

/// `~light_sheets`: the sheet of light of each laser while it burns, according to the topics
/// `trigger_state` and `trigger_events`.
class LightSheets {
 public:
  LightSheets(const scan_cell_common::ScannerModel& scanner, const SheetSize& size);

 private:
  struct Sheet {
    std::size_t laser;
    visualization_msgs::Marker marker;
    bool burns;  //!< as it was last published
  };

  void publish();
  void publish_changes();

  BurningLasers burning_;
  std::vector<Sheet> sheets_;
  ros::Publisher markers_;
  ros::Subscriber states_, pulses_;
  ros::WallTimer refresh_;
};

}  // namespace scan_calibration
