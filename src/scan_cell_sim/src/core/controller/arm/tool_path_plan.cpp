// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "controller/arm/tool_path.h"

namespace scan_cell_sim {
namespace {

constexpr double kSpinUp = 4;      // [1/s] full rotational speed in a quarter of a second
constexpr double kReduced = 0.25;  // [m/s] of the flange in mode programming: ISO 10218-1

void refuse_elsewhere(const Eigen::Isometry3d& stands, const Eigen::Isometry3d& wanted,
                      std::size_t waypoint) {
  constexpr double kPlace = 1e-3;             // [m] c4g_protocol.md
  constexpr double kTurn = 0.3 * M_PI / 180;  // [rad] c4g_protocol.md
  const double off = (stands.translation() - wanted.translation()).norm();
  const double turned = Eigen::AngleAxisd(stands.linear().transpose() * wanted.linear()).angle();
  if (off <= kPlace && turned <= kTurn) return;
  throw ControllerRefusal(ControllerErrorCode::kNotAtStart,
                          fmt::format("the tip is {:.3f} mm and {:.3f} deg from waypoint {}",
                                      off * 1e3, turned * 180 / M_PI, waypoint));
}

/// One step from knot to knot, each within one part.
std::vector<SpeedStep> steps_of(const ToolPath& path, const LineSettings& settings) {
  const auto& knots = path.knots();
  std::vector<SpeedStep> steps;
  auto part = path.parts().begin();
  Eigen::Vector3d before = path.flange(0).translation();
  for (auto knot = knots.begin() + 1; knot != knots.end(); ++knot) {
    if (knot->way > part->end && part + 1 != path.parts().end()) ++part;
    const Eigen::Vector3d here = path.flange(knot->way).translation();
    const double travel = (here - before).norm() / (knot->way - std::prev(knot)->way);
    steps.push_back({knot->way, path.programmed(*part, settings),
                     std::min(knot->max_speed, path.corner_speed(*part, settings.acceleration)),
                     kReduced / std::max(travel, kNothing), part->stop && knot->way >= part->end});
    before = here;
  }
  steps.back().end = 1;
  return steps;
}

}  // namespace

PlannedPath plan_tool_path(const Joints& from, const Eigen::Isometry3d& flange_to_tip,
                           const std::vector<TipWaypoint>& waypoints, std::size_t first,
                           const LineSettings& settings) {
  const auto begin = waypoints.begin() + static_cast<std::ptrdiff_t>(first);
  std::vector<TipWaypoint> rest(begin, waypoints.end());
  const Eigen::Isometry3d stands = flange_of(from) * flange_to_tip;
  refuse_elsewhere(stands, rest.front().tip, first);
  rest.front().tip = stands;
  const double turn_radius = settings.acceleration / (kSpinUp * settings.rotational_speed);
  const auto path = std::make_shared<ToolPath>(flange_to_tip, rest, first, turn_radius);
  PlannedPath plan;
  plan.max_speed = path->follow(from);
  plan.acceleration = settings.acceleration / path->length();
  plan.steps = steps_of(*path, settings);
  plan.path = path;
  return plan;
}

}  // namespace scan_cell_sim
