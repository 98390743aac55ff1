// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <scan_cell_msgs/PreprocessReport.h>

#include <string>

#include "cloud_preprocess/stage.h"

namespace cloud_preprocess {

/// @param failure why the stage failed; empty if it did not
inline scan_cell_msgs::PreprocessReport to_message(const StageReport& report,
                                                   const std::string& failure,
                                                   const std_msgs::Header& header) {
  scan_cell_msgs::PreprocessReport message;
  message.header = header;
  message.stage = report.stage;
  message.ok = static_cast<unsigned char>(failure.empty());
  message.points_in = report.points_in;
  message.points_out = report.points_out;
  message.message = failure.empty() ? report.message : failure;
  return message;
}

}  // namespace cloud_preprocess
