// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.h"

#include "scan_cell_common/parameters/parameter_table.h"

namespace scan_cell_sim {

using scan_cell_common::ParameterTable;

static void describe(ParameterTable& table, CameraOptions& camera) {
  table.add("address", camera.address, "interface to serve the camera on");
  table.add("serial", camera.serial, "serial number");
  table.add("description", camera.genicam_file,
            "GenICam description; none: the package's `config/gige_camera.xml`");
  table.add("region_x", camera.region.x, {0, 65535, "px"}, "first column at power-up");
  table.add("region_y", camera.region.y, {0, 65535, "px"}, "first row at power-up");
  table.add("region_width", camera.region.width, {1, 65535, "px"}, "columns at power-up");
  table.add("region_height", camera.region.height, {1, 65535, "px"}, "rows at power-up");
  table.add("min_period", camera.min_period, {0, 1, "s"}, "shortest time between two exposures");
  table.renamed("least_period", "min_period");
  table.add("wire_rate", camera.wire_rate, {1e6, 1e10, "bytes/s"}, "Gigabit Ethernet");
  table.add("max_pending", camera.max_pending, {1, 10000},
            "pulses whose frames are still to be drawn and sent; more are lost");
  table.renamed("most_pending", "max_pending");
}

static void describe(ParameterTable& table, Optics& optics) {
  const char* const grey = "grey value";
  table.add("stripe_sigma", optics.stripe_sigma, {0.5, 20, "px"}, "cross-section of the line");
  table.add("brightness", optics.brightness, {0, 10000, grey},
            "peak on a white surface, met head on, 0.5 m from the projector");
  table.add("exposure", optics.exposure, {1e-6, 1, "s"},
            "exposure for which `brightness` is given");
  table.add("background", optics.background, {0, 255, grey}, "dark level and stray light");
  table.add("ambient", optics.ambient, {0, 255, grey},
            "of a white surface in the room's light, at `exposure`");
  table.add("read_noise", optics.read_noise, {0, 50, grey}, "standard deviation");
  table.add("shot_noise", optics.shot_noise, {0, 10},
            "standard deviation divided by the square root of the line's grey value");
  table.add("seed", optics.seed, {0, 2147483647},
            "the same seed and frame number give the same image");
}

static void describe(ParameterTable& table, WireFaults& faults) {
  for (const WireFault& fault : kWireFaults) {
    table.add(fault.name, faults.*fault.value, {0, fault.most, fault.time ? "s" : ""},
              (fault.time ? "" : "probability that a datagram ") + std::string(fault.effect));
  }
}

static void describe(ParameterTable& table, ControllerOptions& controller) {
  table.add("address", controller.address, "of the controller");
  table.add("port", controller.port, {1, 65535}, "of the controller, UDP");
  table.add("stream_period", controller.stream_period, {0.002, 0.010, "s"},
            "between two streamed positions");
  table.add("position_noise", controller.noise.position, {0, 0.1, "m"},
            "standard deviation of measured positions");
  table.add("orientation_noise", controller.noise.orientation, {0, 0.1, "rad"},
            "standard deviation of measured orientations");
  table.choice("mode", controller.mode, {"programming", "automatic", "remote"},
               "position of the mode selector at the start");
  table.group("to_client", controller.faults.to_client);
  table.group("from_client", controller.faults.from_client);
}

void describe(ParameterTable& table, Parameters& parameters) {
  table.add("world", parameters.world,
            "world file; none: the package's `config/reference_frame.yaml`");
  table.add("scanner", parameters.scanner,
            "true scanner model; none: the package's `config/scanner.yaml`");
  table.add("cell", parameters.cell,
            "true pose of the robot, `base_link_in_world`; none: the package's "
            "`config/cell.yaml`");
  table.add("true_flange_rate", parameters.true_flange_rate, {0.1, 1000, "Hz"},
            "of `~true_flange` and `~true_outputs`");
  table.add("trigger/address", parameters.options.trigger_address, "of the trigger circuit");
  table.add("trigger/port", parameters.options.trigger_port, {1, 65535},
            "of the trigger circuit, UDP");
  table.group("camera", parameters.options.camera);
  table.group("optics", parameters.options.optics);
  table.group("controller", parameters.controller);
}

void complete(Parameters& parameters, const std::string& config) {
  const auto fill = [&config](std::string& path, const char* file) {
    if (path.empty()) path = config + file;
  };
  fill(parameters.world, "reference_frame.yaml");
  fill(parameters.scanner, "scanner.yaml");
  fill(parameters.cell, "cell.yaml");
  fill(parameters.options.camera.genicam_file, "gige_camera.xml");
}

}  // namespace scan_cell_sim
