// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include <ros/package.h>

#include "scan_cell_common/ros/parameter_reader.h"

namespace scan_cell_sim {
namespace {

using scan_cell_common::ParameterReader;

void read_port(ParameterReader& reader, const std::string& name, std::uint16_t& port) {
  int value = port;
  reader.read(name, value, {1, 65535});
  port = static_cast<std::uint16_t>(value);
}

void read_camera(ParameterReader& reader, CameraOptions& camera) {
  reader.read("camera/address", camera.address);
  reader.read("camera/serial", camera.serial);
  reader.read("camera/description", camera.genicam_file);
  reader.read("camera/region_x", camera.region.x, {0, 65535});
  reader.read("camera/region_y", camera.region.y, {0, 65535});
  reader.read("camera/region_width", camera.region.width, {1, 65535});
  reader.read("camera/region_height", camera.region.height, {1, 65535});
  reader.read("camera/least_period", camera.least_period, {0, 1});
  reader.read("camera/wire_rate", camera.wire_rate, {1e6, 1e10});
  reader.read("camera/most_pending", camera.most_pending, {1, 10000});
}

void read_optics(ParameterReader& reader, Optics& optics) {
  int seed = static_cast<int>(optics.seed);
  reader.read("optics/stripe_sigma", optics.stripe_sigma, {0.5, 20});
  reader.read("optics/brightness", optics.brightness, {0, 10000});
  reader.read("optics/exposure", optics.exposure, {1e-6, 1});
  reader.read("optics/background", optics.background, {0, 255});
  reader.read("optics/ambient", optics.ambient, {0, 255});
  reader.read("optics/read_noise", optics.read_noise, {0, 50});
  reader.read("optics/shot_noise", optics.shot_noise, {0, 10});
  reader.read("optics/seed", seed, {0, 2147483647});
  optics.seed = static_cast<std::uint64_t>(seed);
}

void read_controller(ParameterReader& reader, ControllerOptions& controller) {
  reader.read("controller/address", controller.address);
  read_port(reader, "controller/port", controller.port);
  reader.read("controller/stream_period", controller.stream_period, {0.002, 0.010});
  reader.read("controller/position_noise", controller.noise.position, {0, 0.1});
  reader.read("controller/orientation_noise", controller.noise.orientation, {0, 0.1});
  std::string mode = name_of(controller.mode);
  reader.read_choice("controller/mode", mode, {"programming", "automatic", "remote"});
  controller.mode = controller_mode_of(mode);
  for (const WireFault& fault : kWireFaults) {
    const std::string name = fault.name;
    reader.read("controller/to_client/" + name, controller.faults.to_client.*fault.value,
                {0, fault.most});
    reader.read("controller/from_client/" + name, controller.faults.from_client.*fault.value,
                {0, fault.most});
  }
}

}  // namespace

Parameters Parameters::load(const ros::NodeHandle& node) {
  const std::string config = ros::package::getPath("scan_cell_sim") + "/config/";
  Parameters parameters;
  parameters.world = config + "reference_frame.yaml";
  parameters.scanner = config + "scanner.yaml";
  parameters.cell = config + "cell.yaml";
  parameters.options.camera.genicam_file = config + "gige_camera.xml";

  ParameterReader reader(node);
  reader.read("world", parameters.world);
  reader.read("scanner", parameters.scanner);
  reader.read("cell", parameters.cell);
  reader.read("true_flange_rate", parameters.true_flange_rate, {0.1, 1000});
  reader.read("trigger/address", parameters.options.trigger_address);
  read_port(reader, "trigger/port", parameters.options.trigger_port);
  read_camera(reader, parameters.options.camera);
  read_optics(reader, parameters.options.optics);
  read_controller(reader, parameters.controller);
  reader.refuse_unknown();
  return parameters;
}

}  // namespace scan_cell_sim
