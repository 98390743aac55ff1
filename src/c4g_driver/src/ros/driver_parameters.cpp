// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_parameters.h"

#include <fmt/format.h>
#include <ros/package.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/ros/load_parameters.h"

namespace c4g_driver {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::ParameterTable;

/// The cell's robot_description, or the URDF of the robot that the suite is made for.
std::string robot_description(const ros::NodeHandle& node) {
  std::string name, urdf;
  if (!node.searchParam("robot_description", name)) {
    return scan_cell_common::read_file(ros::package::getPath("c4g_driver") +
                                       "/urdf/smart5_six.urdf");
  }
  if (!node.getParam(name, urdf)) throw InvalidParameter(name, "no text", "give the URDF");
  return urdf;
}

void describe(ParameterTable& table, ClientOptions& client) {
  table.require("address", client.address, "IPv4 of the controller");
  table.add("local_address", client.local_address,
            "IPv4 of this machine's network card that leads to the controller: the driver listens "
            "only there ([network.md](network.md)); 0.0.0.0: on all cards");
  table.add("port", client.port, {1, 65535}, "UDP port of the controller");
  table.add("link_timeout", client.link_timeout, {0.05, 5, "s"},
            "the link is lost after this long without an answer or a fresh pose");
  table.add("tries", client.tries, {1, 100}, "how often a request is sent within `link_timeout`");
  table.add("poll_period", client.poll_period, {0.01, 0.5, "s"},
            "between requests for the pose; they keep the session alive");
  table.add(
      "follow_watch", client.follow_watch, {0.02, 1, "s"},
      "the controller ends a tool path after this long without a request: its outputs go off and "
      "the robot brakes; during a path, requests come ten times as often; 0.5 with `sim:=true`");
  table.add("reconnect_period", client.reconnect_period, {0.05, 60, "s"},
            "between attempts to connect; it does not grow, and the first attempt follows a loss "
            "at once");
  table.add("clock_window", client.clock_window, {0.1, 600, "s"},
            "period over which the least delay of the wire is determined");
  table.add("realtime_priority", client.realtime_priority, {0, 99},
            "SCHED_FIFO priority of the receiving thread, which also publishes; 0: the usual "
            "scheduling. Set one on a host with other work (rights: rtprio in "
            "/etc/security/limits.d)");
  table.add("arrival_position_tolerance", client.arrival.position, {1e-6, 0.1, "m"},
            "of the flange");
  table.add("arrival_angle_tolerance", client.arrival.angle, {1e-6, 0.5, "rad"},
            "of the flange, or of each joint");
  describe(table, client.limits);
}

}  // namespace

void describe(ParameterTable& table, DriverParameters& parameters) {
  describe(table, parameters.client);
  table.add("base_frame", parameters.base_frame,
            "frame of the poses; also the link of the URDF with which the chain begins");
  table.add("flange_frame", parameters.flange_frame, "published on `/tf`");
  table.add("flange_link", parameters.flange_link,
            "link of the URDF at which `flange_frame` is measured");
  table.add("feedback_rate", parameters.feedback_rate, {1, 1000, "Hz"}, "of the move action");
  table.add("status_rate", parameters.status_rate, {1, 1000, "Hz"}, "of `~status`");
  table.add("jog_silence", parameters.jog_silence, {0.05, 1, "s"},
            "the robot stops after this long without a `~jog`");
  table.add("max_jog_override", parameters.max_jog_override, {0.1, 100, "%"},
            "of the programmed speed; highest that a `~jog` may request");
}

DriverParameters DriverParameters::load(const ros::NodeHandle& node) {
  auto parameters = scan_cell_common::load_parameters<DriverParameters>(node);
  ClientOptions& client = parameters.client;
  client.robot = std::make_shared<RobotModel>(robot_description(node), parameters.base_frame,
                                              parameters.flange_link);
  client.limits = narrowed(client.limits, *client.robot);
  return parameters;
}

}  // namespace c4g_driver
