// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "scan_cell_common/ros/parameter_reader.h"

namespace laser_trigger {

Parameters Parameters::load(const ros::NodeHandle& node) {
  scan_cell_common::ParameterReader reader(node);
  Parameters parameters;
  std::string kind = "parallel";
  std::string device = parameters.port.device;
  std::string host = parameters.port.host;
  int port = parameters.port.port;
  reader.read_choice("port", kind, {"parallel", "loopback"});
  reader.read("device", device);
  reader.read("loopback_host", host);
  reader.read("loopback_port", port, {1, 65535});
  parameters.port = kind == "parallel"
                        ? PortAddress::parallel(device)
                        : PortAddress::loopback(host, static_cast<std::uint16_t>(port));
  PulseGenerator::Settings& pulses = parameters.pulses;
  reader.read("pulse_width", pulses.pulse_width, {1e-5, 0.05});
  reader.read("most_rate", pulses.most_rate, {0.1, 10000});
  reader.read("keep_alive_timeout", pulses.keep_alive_timeout, {0.05, 5});
  reader.read("longest_on", pulses.longest_on, {0.1, 3600});
  reader.read("realtime_priority", pulses.realtime_priority, {0, 99});
  reader.read("hang_timeout", parameters.hang_timeout, {0.5, 10});
  reader.refuse_unknown();
  return parameters;
}

}  // namespace laser_trigger
