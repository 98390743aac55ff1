// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "simulator_services.h"

#include <fmt/format.h>
#include <geometry_msgs/PoseStamped.h>
#include <scan_cell_msgs/ToolOutputs.h>
#include <visualization_msgs/MarkerArray.h>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/conversions.h"
#include "scan_cell_common/ros/service_answer.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::answer;
using scan_cell_common::InvalidParameter;

constexpr std::uint32_t kFramesKept = 1000;  // for a slow subscriber; chosen

CellOptions cell_options(const Parameters& parameters) {
  CellOptions options = parameters.options;
  options.scanner = scan_cell_common::load_scanner_model(parameters.scanner);
  options.base_link_in_world = load_base_link_in_world(parameters.cell);
  return options;
}

void check_share(const std::string& name, double share) {
  if (share >= 0 && share <= 1) return;
  throw InvalidParameter(name, fmt::format("{:g}", share), "give 0 .. 1");
}

ControllerMode mode_of(const scan_cell_msgs::SetFaults::Request& faults) {
  if (faults.robot_mode.empty()) return ControllerMode::kRemote;
  try {
    return controller_mode_of(faults.robot_mode);
  } catch (const ControllerRefusal&) {
    throw InvalidParameter("robot_mode", "'" + faults.robot_mode + "'",
                           "give programming, automatic, remote, or nothing");
  }
}

ControllerFaults controller_faults(const scan_cell_msgs::SetFaults::Request& request) {
  ControllerFaults faults;
  WireFaults& answers = faults.to_client;
  answers.lost = request.robot_lost_packets;
  answers.repeated = request.robot_repeated_packets;
  answers.delayed = request.robot_delayed_packets;
  if (request.robot_delay != 0) answers.delay = request.robot_delay;
  answers.jitter = request.robot_jitter;
  answers.held = request.robot_held;
  if (request.robot_hold != 0) answers.hold = request.robot_hold;
  answers.flipped = request.robot_flipped;
  answers.truncated = request.robot_truncated;
  if (request.robot_requests_too) faults.from_client = answers;
  answers.silence = request.robot_silence;
  faults.from_client.silence = request.robot_deafness;
  answers.link_down = faults.from_client.link_down = request.robot_link_down;
  faults.clock_drift = request.robot_clock_drift;
  faults.seed = request.seed;
  return faults;
}

void check(const scan_cell_msgs::SetFaults::Request& faults) {
  constexpr double kMaxDrift = 0.1;         // of the host's rate; chosen
  constexpr double kLongestRestart = 3600;  // [s] chosen
  check_share("camera_lost_frames", faults.camera_lost_frames);
  check_share("camera_lost_packets", faults.camera_lost_packets);
  check_share("robot_lost_packets", faults.robot_lost_packets);
  check_share("robot_repeated_packets", faults.robot_repeated_packets);
  check_share("robot_delayed_packets", faults.robot_delayed_packets);
  const ControllerFaults controller = controller_faults(faults);
  check(controller.to_client, "robot_");
  if (!(controller.from_client.silence >= 0)) {
    throw InvalidParameter("robot_deafness", fmt::format("{:g} s", faults.robot_deafness),
                           "give 0 s or more");
  }
  if (!(std::abs(faults.robot_clock_drift) <= kMaxDrift)) {
    throw InvalidParameter("robot_clock_drift", fmt::format("{:g}", faults.robot_clock_drift),
                           "give -0.1 .. 0.1");
  }
  mode_of(faults);
  if (faults.robot_restart >= 0 && faults.robot_restart <= kLongestRestart) return;
  throw InvalidParameter("robot_restart", fmt::format("{:g} s", faults.robot_restart),
                         "give 0 .. 3600 s");
}

geometry_msgs::PoseStamped to_message(const Eigen::Isometry3d& flange, const ros::Time& stamp) {
  geometry_msgs::PoseStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = "base_link";
  message.pose = scan_cell_common::to_ros_pose(flange);
  return message;
}

visualization_msgs::Marker marker(const Part& part, int id) {
  constexpr double kTolerance = 1e-4;  // [m] fine enough for a display; chosen
  visualization_msgs::Marker result;
  result.header.frame_id = "world";
  result.header.stamp = ros::Time::now();
  result.ns = part.name;
  result.id = id;
  result.type = visualization_msgs::Marker::TRIANGLE_LIST;
  result.pose.orientation.w = 1;
  result.scale.x = result.scale.y = result.scale.z = 1;
  result.color.r = result.color.g = result.color.b = static_cast<float>(part.reflectance);
  result.color.a = 1;
  const Mesh mesh = part.mesh(kTolerance);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      const Eigen::Vector3d& vertex = mesh.vertices[corner];
      geometry_msgs::Point point;
      point.x = vertex.x();
      point.y = vertex.y();
      point.z = vertex.z();
      result.points.push_back(point);
    }
  }
  return result;
}

}  // namespace

SimulatorServices::SimulatorServices(ros::NodeHandle node, const Parameters& parameters)
    : controller_(parameters.controller),
      cell_(cell_options(parameters), load_world(parameters.world), controller_),
      parts_(node.advertise<visualization_msgs::MarkerArray>("parts", 1, true)),
      flange_(node.advertise<geometry_msgs::PoseStamped>("true_flange", 1)),
      outputs_(node.advertise<scan_cell_msgs::ToolOutputs>("true_outputs", 1)),
      exposures_(node.advertise<geometry_msgs::PoseStamped>("true_exposures", kFramesKept)),
      load_world_(node.advertiseService("load_world", &SimulatorServices::load, this)),
      set_faults_(node.advertiseService("set_faults", &SimulatorServices::set, this)),
      timer_(node.createWallTimer(ros::WallDuration(1 / parameters.true_flange_rate),
                                  &SimulatorServices::publish_robot, this)),
      lost_pulses_(node, cell_.camera(), parameters.options.camera) {
  publish_parts(load_world(parameters.world));
  cell_.observe([this](const Cell::TrueExposure& exposure) { publish_exposure(exposure); });
}

SimulatorServices::~SimulatorServices() {
  cell_.observe(nullptr);
}

bool SimulatorServices::load(scan_cell_msgs::LoadWorld::Request& request,
                             scan_cell_msgs::LoadWorld::Response& response) {
  return answer(response, [&] {
    const World world = load_world(request.path);
    cell_.set_world(world);
    publish_parts(world);
  });
}

bool SimulatorServices::set(scan_cell_msgs::SetFaults::Request& request,
                            scan_cell_msgs::SetFaults::Response& response) {
  return answer(response, [&] {
    check(request);
    apply(request);
  });
}

void SimulatorServices::apply(const scan_cell_msgs::SetFaults::Request& request) {
  cell_.camera().set_power(!request.camera_off);  // these two may fail
  cell_.circuit().set_power(!request.trigger_circuit_lost);
  CameraFaults camera;
  camera.lost_frames = request.camera_lost_frames;
  camera.lost_packets = request.camera_lost_packets;
  camera.seed = request.seed;
  cell_.camera().set_faults(camera);
  controller_.set_faults(controller_faults(request));
  attend(request);
}

void SimulatorServices::attend(const scan_cell_msgs::SetFaults::Request& request) {
  controller_.select(mode_of(request));
  if (request.robot_e_stop) {
    controller_.press_e_stop();
    return;
  }
  controller_.release_e_stop();
  controller_.reset_alarms();
  controller_.switch_drives(!request.robot_drives_off);
  if (!request.robot_motion_error.empty()) controller_.fail_motion(request.robot_motion_error);
  if (request.robot_restart > 0) controller_.restart(request.robot_restart);
}

void SimulatorServices::publish_parts(const World& world) {
  visualization_msgs::MarkerArray markers;
  markers.markers.emplace_back();
  markers.markers.back().action = visualization_msgs::Marker::DELETEALL;
  for (const Part& part : world.parts) {
    markers.markers.push_back(marker(part, static_cast<int>(markers.markers.size())));
  }
  parts_.publish(markers);
}

void SimulatorServices::publish_robot(const ros::WallTimerEvent&) {
  const ros::Time now = ros::Time::now();
  const scan_cell_common::Nanoseconds instant = scan_cell_common::from_ros(now);
  flange_.publish(to_message(controller_.flange_at(instant), now));
  scan_cell_msgs::ToolOutputs outputs;
  outputs.header.stamp = now;
  outputs.outputs = controller_.outputs_at(instant);
  outputs_.publish(outputs);
}

void SimulatorServices::publish_exposure(const Cell::TrueExposure& exposure) {
  exposures_.publish(to_message(exposure.flange, scan_cell_common::to_ros(exposure.time)));
}

}  // namespace scan_cell_sim
