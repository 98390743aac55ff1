// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/parts/extrusion.h"
#include "scanner_views/parts/part_list.h"

namespace scanner_views {
namespace {

using cases::Loop;

Mesh extruded(Draws& draws, Loop section, double length) {
  const double x = draws.between(0.85, 1.2), z = draws.between(0.85, 1.2);
  for (Eigen::Vector2d& point : section)
    point = {x * point.x(), z * point.y()};
  const double lengthened = length * draws.between(0.85, 1.2);
  const double front = draws.between(0.25, 0.5);
  return solid_of(Extrusion{section, lengthened, front, draws.between(-0.25, 0.1)});
}

/// A bent sheet: its line, and the same line offset by the sheet's thickness.
Loop hat_section() {
  return {{-0.060, 0},      {-0.030, 0},       {-0.022, 0.032},   {0.022, 0.032},
          {0.030, 0},       {0.060, 0},        {0.060, 0.0025},   {0.0319, 0.0025},
          {0.0239, 0.0345}, {-0.0239, 0.0345}, {-0.0319, 0.0025}, {-0.060, 0.0025}};
}

Loop channel_section() {
  return {{-0.035, 0},    {0.035, 0},      {0.035, 0.045}, {0.030, 0.045},
          {0.030, 0.006}, {-0.030, 0.006}, {-0.030, 0.03}, {-0.035, 0.03}};
}

Loop angle_section() {
  return {{-0.045, 0},     {0.045, 0},      {0.045, 0.007},
          {-0.038, 0.007}, {-0.038, 0.055}, {-0.045, 0.055}};
}

Loop wedge_section() {
  return {{-0.06, 0}, {0.06, 0}, {0.06, 0.012}, {-0.02, 0.048}, {-0.06, 0.048}};
}

}  // namespace

std::vector<ViewPart> profile_parts(Draws& draws) {
  std::vector<ViewPart> parts;
  parts.push_back({"hat profile", extruded(draws, hat_section(), 0.24)});
  parts.push_back({"channel", extruded(draws, channel_section(), 0.22)});
  parts.push_back({"angle profile", extruded(draws, angle_section(), 0.2)});
  parts.push_back({"wedge", extruded(draws, wedge_section(), 0.11)});
  return parts;
}

}  // namespace scanner_views
