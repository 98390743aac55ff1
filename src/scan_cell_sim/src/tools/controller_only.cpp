// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The emulated robot controller alone, for trying the driver without a camera.
#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstring>
#include <iostream>
#include <vector>

#include "panel.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using scan_cell_sim::ControllerOptions;
using scan_cell_sim::Panel;

/// SIGINT and SIGTERM, for all threads, as a descriptor to read.
int ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signalfd(-1, &signals, SFD_CLOEXEC);
}

/// Carries out typed lines until a signal ends the program; the end of the input does not end it.
void attend(Panel& panel, int signals) {
  std::string typed;
  pollfd sources[] = {{signals, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
  while (poll(sources, 2, -1) < 0 || sources[0].revents == 0) {
    if (sources[1].revents == 0) continue;
    char bytes[256];
    const ssize_t length = read(STDIN_FILENO, bytes, sizeof bytes);
    if (length <= 0) sources[1].fd = -1;
    typed.append(bytes, static_cast<std::size_t>(std::max<ssize_t>(length, 0)));
    for (std::size_t end = typed.find('\n'); end != std::string::npos; end = typed.find('\n')) {
      const std::string said = panel.carry_out(typed.substr(0, end));
      if (!said.empty()) std::cout << said << std::endl;
      typed.erase(0, end + 1);
    }
  }
}

/// Removes the names that roslaunch adds for ROS (__name:=...).
std::vector<char*> without_ros_names(int argc, char** argv) {
  std::vector<char*> rest(argv, argv + argc);
  rest.erase(std::remove_if(rest.begin(), rest.end(),
                            [](const char* word) { return std::strstr(word, ":=") != nullptr; }),
             rest.end());
  return rest;
}

/// Options in a person's units.
struct Typed {
  double stream_period = 4;      // [ms]
  double position_noise = 0;     // [mm]
  double orientation_noise = 0;  // [deg]
  std::string mode = "remote";
};

void add_options(CLI::App& app, ControllerOptions& options, Typed& typed) {
  app.add_option("--address", options.address, "IPv4 address to listen on")->capture_default_str();
  app.add_option("--port", options.port, "UDP port")->capture_default_str();
  app.add_option("--stream-period", typed.stream_period, "[ms] between positions while moving")
      ->capture_default_str();
  app.add_option("--mode", typed.mode, "mode selector: programming, automatic, remote")
      ->check(CLI::IsMember({"programming", "automatic", "remote"}))
      ->capture_default_str();
  app.add_option("--position-noise", typed.position_noise, "[mm] standard deviation")
      ->capture_default_str();
  app.add_option("--orientation-noise", typed.orientation_noise, "[deg] standard deviation")
      ->capture_default_str();
  app.add_option("--seed", options.noise.seed, "of noise and faults")->capture_default_str();
  app.add_option("--clock-drift", options.faults.clock_drift,
                 "1e-6: one microsecond per second too fast")
      ->capture_default_str();
  for (const scan_cell_sim::WireFault& fault : scan_cell_sim::kWireFaults) {
    app.add_option_function<double>(
           std::string("--") + fault.name,
           [&options, &fault](const double& value) {
             set_fault(options.faults.to_client, fault.name, value);
             set_fault(options.faults.from_client, fault.name, value);
           },
           (fault.time ? "[ms] " : "probability that a datagram ") + std::string(fault.effect))
        ->group("Faults of the wire, in both directions");
  }
}

int serve(ControllerOptions options, const Typed& typed) {
  constexpr double kMillisecond = 1e-3;  // [s]
  using scan_cell_common::kMillimetre;
  options.stream_period = typed.stream_period * kMillisecond;
  options.mode = scan_cell_sim::controller_mode_of(typed.mode);
  options.noise.position = typed.position_noise * kMillimetre;
  options.noise.orientation = typed.orientation_noise * M_PI / 180;
  options.faults.seed = options.noise.seed;
  const int signals = ending_signals();  // before the controller's thread begins
  scan_cell_sim::Controller controller(options);
  Panel panel(controller, options.faults);
  std::cout << "listening on " << options.address << ":" << controller.port() << std::endl;
  attend(panel, signals);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  ControllerOptions options;
  Typed typed;
  CLI::App app{
      "Emulator of a robot controller that serves C4G over UDP (c4g_protocol.md). Lines on "
      "the standard input operate its panel and its cable: type help"};
  add_options(app, options, typed);
  std::vector<char*> words = without_ros_names(argc, argv);
  return scan_cell_common::tool_main("controller_only", app, static_cast<int>(words.size()),
                                     words.data(), [&] { return serve(options, typed); });
}
