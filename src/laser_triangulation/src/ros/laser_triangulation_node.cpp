// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/services.h"
#include "triangulation_services.h"

int main(int argc, char** argv) {
  using namespace laser_triangulation;  // NOLINT
  return scan_cell_common::services_main<TriangulationServices, Parameters>(
      argc, argv, "laser_triangulation",
      "Turns profiles with a pose into points in the fixed frame.");
}
