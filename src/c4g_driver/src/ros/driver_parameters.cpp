// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_parameters.h"

#include <ros/package.h>

#include <limits>

#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"
#include "scan_cell_common/ros/parameter_reader.h"

namespace c4g_driver {
namespace {

using scan_cell_common::InvalidParameter;
using scan_cell_common::ParameterReader;
using Range = ParameterReader::Range;

template <int N>
void read_vector(ParameterReader& reader, const ros::NodeHandle& node, const std::string& name,
                 Eigen::Matrix<double, N, 1>& vector, const Range& range) {
  std::vector<double> values(vector.begin(), vector.end());
  reader.read(name, values, range);
  if (values.size() != N) {
    throw InvalidParameter(node.resolveName(name), std::to_string(values.size()) + " numbers",
                           "give " + std::to_string(N));
  }
  vector = Eigen::Map<const Eigen::Matrix<double, N, 1>>(values.data());
}

template <int N>
void check_order(const ros::NodeHandle& node, const std::string& least, const std::string& most,
                 const Eigen::Matrix<double, N, 1>& lower,
                 const Eigen::Matrix<double, N, 1>& upper) {
  if ((lower.array() < upper.array()).all()) return;
  throw InvalidParameter(node.resolveName(least), "not below " + most,
                         "give each element below that of " + most);
}

/// The URDF of the cell's robot_description, or the robot that the suite is made for.
std::string robot_description(const ros::NodeHandle& node) {
  std::string name, urdf;
  if (!node.searchParam("robot_description", name)) {
    return scan_cell_common::read_file(ros::package::getPath("c4g_driver") +
                                       "/urdf/smart5_six.urdf");
  }
  if (!node.getParam(name, urdf)) throw InvalidParameter(name, "no text", "give the URDF");
  return urdf;
}

void read_limits(ParameterReader& reader, const ros::NodeHandle& node, const RobotModel& robot,
                 RobotLimits& limits) {
  const Range metres{-10, 10};
  const Range radians{-100, 100};
  std::string operation = "manual";
  reader.read_choice("operation", operation, {"manual", "automatic"});
  limits.operation = operation == "automatic" ? Operation::Automatic : Operation::Manual;
  limits.joint_lower = robot.lower();
  limits.joint_upper = robot.upper();
  read_vector(reader, node, "workspace_min", limits.workspace_min, metres);
  read_vector(reader, node, "workspace_max", limits.workspace_max, metres);
  read_vector(reader, node, "joint_lower", limits.joint_lower, radians);
  read_vector(reader, node, "joint_upper", limits.joint_upper, radians);
  check_order(node, "workspace_min", "workspace_max", limits.workspace_min, limits.workspace_max);
  check_order(node, "joint_lower", "joint_upper", limits.joint_lower, limits.joint_upper);
  reader.read("most_linear_speed", limits.most_linear_speed, {1e-4, 10});
  reader.read("most_camera_rate", limits.most_camera_rate, {0, 1e5});
}

}  // namespace

DriverParameters DriverParameters::load(const ros::NodeHandle& node) {
  constexpr int kLastPort = std::numeric_limits<std::uint16_t>::max();
  DriverParameters parameters;
  ClientOptions& client = parameters.client;
  ParameterReader reader(node);
  int port = client.port;
  reader.read("local_address", client.local_address);
  reader.require("address", client.address);
  reader.read("port", port, {1, kLastPort});
  client.port = static_cast<std::uint16_t>(port);
  reader.read("base_frame", parameters.base_frame);
  reader.read("flange_frame", parameters.flange_frame);
  reader.read("flange_link", parameters.flange_link);
  reader.read("link_timeout", client.link_timeout, {0.05, 5});
  reader.read("tries", client.tries, {1, 100});
  reader.read("poll_period", client.poll_period, {0.01, 0.5});
  reader.read("reconnect_period", client.reconnect_period, {0.05, 60});
  reader.read("clock_window", client.clock_window, {0.1, 600});
  reader.read("realtime_priority", client.realtime_priority, {0, 99});
  reader.read("arrival_position_tolerance", client.arrival.position, {1e-6, 0.1});
  reader.read("arrival_angle_tolerance", client.arrival.angle, {1e-6, 0.5});
  reader.read("feedback_rate", parameters.feedback_rate, {1, 1000});
  reader.read("status_rate", parameters.status_rate, {1, 1000});
  client.robot = std::make_shared<RobotModel>(robot_description(node), parameters.base_frame,
                                              parameters.flange_link);
  read_limits(reader, node, *client.robot, client.limits);
  reader.refuse_unknown();
  client.limits = narrowed(client.limits, *client.robot);
  return parameters;
}

}  // namespace c4g_driver
