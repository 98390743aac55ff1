// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The trigger circuit from the command line: no ROS master is needed.
#include <CLI/CLI.hpp>

#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/interrupts.h"
#include "scan_cell_common/tools/tool_main.h"
#include "trigger_orders.h"

namespace {

using laser_trigger::Order;
using laser_trigger::PortAddress;

CLI::App* add_pulses(CLI::App& app, Order& order, std::vector<int>& lasers) {
  CLI::App* const pulses = app.add_subcommand(
      "pulses", "Pulses the camera a given number of times, or for a given time");
  pulses->add_option("--rate", order.rate, "[Hz] 0.1 .. 1000")
      ->check(CLI::PositiveNumber)
      ->required();
  CLI::Option_group* const end = pulses->add_option_group("end", "One of these");
  end->add_option("--count", order.pulses, "pulses")->check(CLI::PositiveNumber);
  end->add_option("--seconds", order.seconds, "[s] up to 300");
  end->require_option(1);
  pulses->add_option("--laser", lasers, "0, 1 or both: on during the pulses; without: none")
      ->check(CLI::IsMember({0, 1}));
  pulses->add_flag("--alternate", order.alternate,
                   "both lasers take turns, pulse by pulse, laser_0 first");
  return pulses;
}

CLI::App* add_laser(CLI::App& app, Order& order, std::vector<int>& lasers) {
  CLI::App* const laser = app.add_subcommand("laser", "Switches one laser on, without pulses");
  laser->add_option("number", lasers, "0 or 1")
      ->check(CLI::IsMember({0, 1}))
      ->expected(1)
      ->required();
  laser->add_option("--seconds", order.seconds, "[s] up to 300")->required();
  return laser;
}

std::uint8_t mask_of(const std::vector<int>& lasers) {
  std::uint8_t mask = 0;
  for (const int laser : lasers)
    mask = static_cast<std::uint8_t>(mask | 1 << laser);
  return mask;
}

}  // namespace

/// Exits 0 on success, 2 if the order is invalid or a signal ended it early, 1 otherwise.
int main(int argc, char** argv) {
  PortAddress port = PortAddress::parallel(PortAddress().device);
  scan_cell_common::ParameterOptions typed;
  Order order;
  std::vector<int> lasers;
  double watched = 0;
  CLI::App app(
      "Pulses the camera and switches the lasers on and off. However it ends, the lines are low "
      "afterwards. The node laser_trigger must not run at the same time.");
  app.require_subcommand(1);
  typed.add(app, port);
  CLI::App* const pulses = add_pulses(app, order, lasers);
  CLI::App* const laser = add_laser(app, order, lasers);
  CLI::App* const watch = app.add_subcommand(
      "watch",
      "Takes the place of the simulator and prints each pulse and each switching of a laser");
  watch->add_option("--seconds", watched, "[s] how long; without: until Ctrl-C")
      ->check(CLI::NonNegativeNumber);
  for (CLI::App* command : {pulses, laser, watch})
    command->fallthrough();
  return scan_cell_common::tool_main(
      "trigger", app, argc, argv,
      [&] {
        const scan_cell_common::CatchInterrupts catch_interrupts;
        typed.read(port);
        order.lasers = mask_of(lasers);
        if (watch->parsed()) {
          laser_trigger::watch(port, watched);
        } else {
          laser_trigger::carry_out(order, port);
        }
        return 0;
      },
      scan_cell_common::kRefused);
}
