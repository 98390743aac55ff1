// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "measurements.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

double degrees(double angle) {
  return angle * 180 / M_PI;
}

void show_face(double lean, double roll) {
  const auto face = pass_planner::measure_face(SCANNER_FILE, lean, roll);
  std::printf("%16.0f %16.0f %10.1f %% %8.3f\n", degrees(face.light_angle),
              degrees(face.sight_angle), 100 * face.measured, 1e3 * face.rms);
}

void show_faces() {
  std::printf(
      "a face that leans: places with a scanned point within 1 mm, and RMS of the points\n");
  std::printf("%16s %16s %12s %8s\n", "light [deg]", "sight [deg]", "measured", "RMS [mm]");
  const double step = 5 * M_PI / 180;
  for (int i = 6; i <= 12; ++i)  // away from the light
    show_face(-i * step, 0);
  for (int i = 10; i <= 17; ++i)  // towards the light, away from the camera
    show_face(i * step, 0);
  for (int i = 10; i <= 16; ++i)  // to the side
    show_face(0, i * step);
}

void show_agreement(int parts) {
  const auto found = pass_planner::measure_agreement(SCANNER_FILE, 1, parts);
  const auto percent = [](std::size_t part, std::size_t whole) {
    return whole == 0 ? 100 : 100 * static_cast<double>(part) / static_cast<double>(whole);
  };
  std::printf("%d parts, one line each\n", parts);
  std::printf(
      "seen:                     %5zu waypoints, with a scanned point within 1 mm: %.1f %%\n",
      found.seen, percent(found.seen_and_there, found.seen));
  std::printf("shadowed or out of range: %5zu waypoints, without one: %.1f %%\n", found.hidden,
              percent(found.hidden_and_gone, found.hidden));
  std::printf("grazing:                  %5zu waypoints, without one: %.1f %%\n", found.grazing,
              percent(found.grazing_and_gone, found.grazing));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Holds what the planner says is seen against simulated scans");
  int parts = 20;
  bool faces = true;
  app.add_option("--parts", parts, "how many parts and poses to draw")->capture_default_str();
  app.add_flag("!--no-faces", faces, "leaves the leaning faces out");
  return scan_cell_common::tool_main("bench_pass_planner", app, argc, argv, [&] {
    if (faces) show_faces();
    show_agreement(parts);
    return 0;
  });
}
