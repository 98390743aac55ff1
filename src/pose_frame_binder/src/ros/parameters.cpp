// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "scan_cell_common/ros/parameter_reader.h"

namespace pose_frame_binder {
namespace {

ConstantSpeed load_constant_speed(scan_cell_common::ParameterReader& reader) {
  constexpr double kMost = 100;  // [m]
  ConstantSpeed motion;
  std::vector<double> start, end;
  std::string moving = "scanner";
  reader.read("constant_speed/start", start, {-kMost, kMost});
  reader.read("constant_speed/end", end, {-kMost, kMost});
  reader.read("constant_speed/speed", motion.speed, {0, 100});
  reader.read("constant_speed/frame_rate", motion.frame_rate, {0, 1e5});
  reader.read_choice("constant_speed/moving", moving, {"object", "scanner"});
  if (!start.empty()) motion.start = pose_from("constant_speed/start", start);
  if (!end.empty()) motion.end = pose_from("constant_speed/end", end);
  motion.object_moves = moving == "object";
  return motion;
}

LookupParameters load_lookup(scan_cell_common::ParameterReader& reader) {
  LookupParameters lookup;
  reader.read("lookup/address", lookup.address);
  reader.read("lookup/port", lookup.port, {0, 65535});
  reader.read("lookup/most_clients", lookup.limits.most_clients, {1, 64});
  reader.read("lookup/idle_time", lookup.limits.idle_time, {1, 3600});
  return lookup;
}

}  // namespace

Parameters Parameters::load(const ros::NodeHandle& node) {
  scan_cell_common::ParameterReader reader(node);
  Parameters parameters;
  Settings& settings = parameters.settings;
  std::string method = "interpolate";
  auto most_poses = static_cast<int>(settings.most_poses);
  auto most_pending_frames = static_cast<int>(settings.most_pending_frames);
  reader.read("fixed_frame", parameters.frames.fixed);
  reader.read("base_frame", parameters.frames.base);
  reader.read("flange_frame", parameters.frames.flange);
  reader.read("transform_timeout", parameters.transform_timeout, {0, 60});
  reader.read_choice("method", method, {"constant_speed", "first_pose", "interpolate"});
  reader.read("most_pose_gap", settings.most_pose_gap, {1e-4, 10});
  reader.read("pose_settle", settings.pose_settle, {0, 1});
  reader.read("pose_delay", settings.pose_delay, {-1, 1});
  reader.read("camera_latency", settings.camera_latency, {-0.1, 1});
  reader.read("latency_tolerance", settings.latency_tolerance, {1e-5, 1});
  reader.read("frames_to_agree", settings.frames_to_agree, {2, 32});
  reader.read("most_acceleration", settings.most_acceleration, {0.01, 1000});
  reader.read("most_speed", settings.most_speed, {0.001, 100});
  reader.read("most_poses", most_poses, {100, 1e9});
  reader.read("most_pending_frames", most_pending_frames, {10, 1e7});
  settings.constant_speed = load_constant_speed(reader);
  parameters.lookup = load_lookup(reader);
  reader.refuse_unknown();
  check(parameters.frames);
  settings.method = method_from(method);
  settings.most_poses = static_cast<std::size_t>(most_poses);
  settings.most_pending_frames = static_cast<std::size_t>(most_pending_frames);
  check(settings);
  return parameters;
}

}  // namespace pose_frame_binder
