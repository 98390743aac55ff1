// Copyright 2026 the scan cell developers SPDX-License-Identifier: BSD-3-Clause Sends profiles
// through the running binder and triangulation, under their own ROS master, as nodelets in one
// process and as nodes, and compares with two nodes that only pass the profiles on.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "chain_run.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/testing/child_process.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace pose_frame_binder;  // NOLINT
using scan_cell_common::ChildProcess;

namespace {

/// Each run has its own process, so that its memory can be measured.
int run_all(const std::string& program, const Pace& pace) {
  const std::string port = fmt::format("{}", scan_cell_common::free_port());
  setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
  setenv("ROS_IP", "127.0.0.1", 1);
  const ChildProcess master({"rosmaster", "--core", "-p", port}, true);
  double load[1] = {0};
  getloadavg(load, 1);
  std::printf("%g profiles/s of %zu rows for %g s, %u processors, load before the run %.1f\n",
              pace.rate, pace.rows, pace.seconds, std::thread::hardware_concurrency(), load[0]);
  std::fflush(stdout);
  for (const char* kind : {"nodelets", "nodes", "relays"}) {
    ChildProcess run({program, "--run", kind, "--seconds", fmt::format("{}", pace.seconds),
                      "--rate", fmt::format("{}", pace.rate), "--rows",
                      fmt::format("{}", pace.rows)});
    if (const int code = run.wait(); code != 0) return code;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe");
  Pace pace;
  std::string kind, from, to;
  CLI::App app("Profiles through the running chain.");
  app.add_option("--seconds", pace.seconds, "of each run");
  app.add_option("--rate", pace.rate, "profiles a second");
  app.add_option("--rows", pace.rows, "of a profile");
  app.add_option("--run", kind, "for the program itself: nodelets, nodes, relays or relay");
  app.add_option("--from", from, "for the program itself: topic that a relay hands on");
  app.add_option("--to", to, "for the program itself: where");
  return scan_cell_common::tool_main("bench_running_chain", app, argc, argv, [&] {
    if (kind.empty()) return run_all(program, pace);
    if (kind == "relay") return relay(from, to);
    return kind == "relays" ? run_relays(program, pace) : run_chain(program, kind, pace);
  });
}
