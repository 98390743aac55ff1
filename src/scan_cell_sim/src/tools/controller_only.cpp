// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// The emulated robot controller alone, for people who want to try the driver without a camera.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstring>
#include <iostream>
#include <vector>

#include "scan_cell_sim/controller/controller.h"

namespace {

/// Waits until somebody ends the program, without a handler that could do too much.
void wait_for_end(const sigset_t& signals) {
  int signal = 0;
  sigwait(&signals, &signal);
}

/// roslaunch adds names for ROS (__name:=...), which mean nothing here.
std::vector<char*> without_ros_names(int argc, char** argv) {
  std::vector<char*> rest(argv, argv + argc);
  rest.erase(std::remove_if(rest.begin(), rest.end(),
                            [](const char* word) { return std::strstr(word, ":=") != nullptr; }),
             rest.end());
  return rest;
}

}  // namespace

int main(int argc, char** argv) {
  scan_cell_sim::ControllerOptions options;
  scan_cell_sim::ControllerFaults faults;
  double stream_period_ms = 4;
  double noise_mm = 0;
  double noise_deg = 0;
  double delay_ms = 10;
  CLI::App app{"Emulator of a robot controller that serves C4G over UDP (docs/c4g_protocol.md)"};
  app.add_option("--address", options.address, "IPv4 address to listen on")->capture_default_str();
  app.add_option("--port", options.port, "UDP port")->capture_default_str();
  app.add_option("--stream-period", stream_period_ms, "[ms] between positions while moving")
      ->capture_default_str();
  app.add_option("--position-noise", noise_mm, "[mm] standard deviation")->capture_default_str();
  app.add_option("--orientation-noise", noise_deg, "[deg] standard deviation")
      ->capture_default_str();
  app.add_option("--seed", options.noise.seed, "of noise and faults")->capture_default_str();
  app.add_option("--clock-drift", faults.clock_drift, "1e-6: one microsecond a second too fast")
      ->capture_default_str();
  app.add_option("--lost", faults.to_client.lost, "probability that a datagram is lost")
      ->capture_default_str();
  app.add_option("--repeated", faults.to_client.repeated, "probability that it comes twice")
      ->capture_default_str();
  app.add_option("--delayed", faults.to_client.delayed, "probability that it is overtaken")
      ->capture_default_str();
  app.add_option("--delay", delay_ms, "[ms] of a delayed datagram")->capture_default_str();
  const std::vector<char*> words = without_ros_names(argc, argv);
  CLI11_PARSE(app, static_cast<int>(words.size()), words.data());
  options.stream_period = stream_period_ms * 1e-3;
  options.noise.position = noise_mm * 1e-3;
  options.noise.orientation = noise_deg * M_PI / 180;
  options.fault_seed = options.noise.seed;
  faults.to_client.delay = delay_ms * 1e-3;
  faults.from_client = faults.to_client;

  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  try {
    scan_cell_sim::Controller controller(options);
    controller.set_faults(faults);
    std::cout << "listening on " << options.address << ":" << controller.port() << std::endl;
    wait_for_end(signals);
  } catch (const std::exception& error) {
    std::cerr << "controller_only: " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
