// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
// Counts points on the wrong laser's plane in a long scan with alternating lasers, by the
// simulator's ground truth: trigger, simulated camera, peak detector, binder and triangulation are
// those of the suite.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "alternating_chain.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"

int main(int argc, char** argv) {
  scan_cell_demo::AlternatingScan scan;
  scan.config = CONFIG_FOLDER;
  scan.rate = 485;
  scan.pulses = 20000;
  scan.lost_frames = 0.01;
  CLI::App app("Points of the wrong laser's plane in a scan with alternating lasers");
  app.add_option("--rate", scan.rate, "[Hz] of the pulses")->capture_default_str();
  app.add_option("--pulses", scan.pulses, "sent")->capture_default_str();
  app.add_option("--rows", scan.rows, "[px] of the image")->capture_default_str();
  return scan_cell_common::tool_main("bench_alternating_lasers", app, argc, argv, [&] {
    const scan_cell_demo::AlternatingResult result = run(scan);
    const auto number = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    using scan_cell_common::kMillimetres;
    std::printf(
        "alternating lasers in the simulator, %llu pulses at %g Hz (%llu left out): %llu frames, "
        "%llu bound, %llu of an uncertain laser\n"
        "  points of laser_0 %llu, of laser_1 %llu; of the wrong plane %llu (goal 0); farthest "
        "from the truth %.3f mm; with the lasers swapped all would be off by %.0f mm or more\n",
        number(result.pulses), scan.rate, number(result.missed), number(result.frames),
        number(result.bound), number(result.uncertain), number(result.points[0]),
        number(result.points[1]), number(result.wrong), kMillimetres * result.worst,
        kMillimetres * result.swapped);
    return 0;
  });
}
