// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include <filesystem>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/ros/parameter_reader.h"

namespace laser_triangulation {

Parameters Parameters::load(const ros::NodeHandle& node) {
  scan_cell_common::ParameterReader reader(node);
  Parameters parameters;
  PeakLimits& limits = parameters.limits;
  constexpr double kWidest = 1e4;
  constexpr double kBrightest = 65535;
  auto most_points = static_cast<int>(parameters.most_points);
  reader.require("scanner", parameters.scanner);
  reader.read("least_width", limits.least_width, {0, kWidest});
  reader.read("most_width", limits.most_width, {0, kWidest});
  reader.read("least_intensity", limits.least_intensity, {0, kBrightest});
  reader.read("most_intensity", limits.most_intensity, {0, kBrightest});
  reader.read("least_range", limits.least_range, {0.001, 100});
  reader.read("most_range", limits.most_range, {0.001, 100});
  reader.read("publish_rate", parameters.publish_rate, {0.1, 100});
  reader.read("most_points", most_points, {1000, 2e8});
  auto most_message_points = static_cast<int>(parameters.most_message_points);
  reader.read("most_message_points", most_message_points, {1, 4e7});
  reader.read("cloud_folder", parameters.cloud_folder);
  reader.refuse_unknown();
  if (!std::filesystem::is_directory(parameters.cloud_folder)) {
    throw scan_cell_common::InvalidParameter(node.resolveName("cloud_folder"),
                                             "'" + parameters.cloud_folder + "'",
                                             "give a folder that is there");
  }
  parameters.most_message_points = static_cast<std::size_t>(most_message_points);
  parameters.most_points = static_cast<std::size_t>(most_points);
  return parameters;
}

}  // namespace laser_triangulation
