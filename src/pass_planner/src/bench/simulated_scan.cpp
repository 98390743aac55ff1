// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scan.h"

#include "laser_triangulation/triangulator.h"
#include "scan_cell_common/pose/timed_pose.h"
#include "scan_cell_sim/laser_line_renderer.h"
#include "tecnogamma_camera/peak_detector.h"

namespace pass_planner {
namespace {

using Eigen::Isometry3d;

constexpr double kStep = 0.0006;  // [m] from frame to frame
constexpr double kTurn = 0.003;   // [rad] the same where the flange turns: 0.6 mm at 0.2 m

std::vector<Isometry3d> exposures_along(const std::vector<Isometry3d>& way) {
  std::vector<Isometry3d> exposures;
  double left = 0;  // of a step, to the next exposure
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = (way[i].translation() - way[i - 1].translation()).norm();
    const double turn =
        Eigen::AngleAxisd(way[i - 1].linear().transpose() * way[i].linear()).angle();
    const double steps = std::max(length / kStep, turn / kTurn);
    for (; left < steps; left += 1)
      exposures.push_back(scan_cell_common::interpolate(way[i - 1], way[i], left / steps));
    left -= steps;
  }
  return exposures;
}

}  // namespace

std::vector<Eigen::Vector3d> simulated_scan(const scan_cell_sim::Scene& scene,
                                            const scan_cell_common::ScannerModel& scanner,
                                            const Sweep& sweep) {
  const scan_cell_sim::LaserLineRenderer renderer(scanner, {});
  const scan_cell_sim::Region region{kRegionX, kRegionY, kRegionWidth, kRegionHeight};
  tecnogamma_camera::DetectorSettings settings;
  settings.trigger_level = 25;  // launch/devices.launch
  const auto detector = tecnogamma_camera::make_detector("fir_derivative", settings);
  laser_triangulation::Triangulator triangulator(scanner, {});
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(region.width * region.height));
  std::vector<laser_triangulation::ScanPoint> points;
  tecnogamma_camera::PeakProfile peaks;
  scan_cell_sim::Exposure exposure;
  exposure.lasers = static_cast<std::uint8_t>(1U << sweep.laser);
  for (const Isometry3d& flange : exposures_along(sweep.flange)) {
    exposure.camera = flange * scanner.flange_to_camera;
    ++exposure.frame;
    renderer.render(scene, exposure, region, pixels.data());
    detector->detect(tecnogamma_camera::ImageView8{pixels.data(), region.width, region.height,
                                                   region.width, region.x, region.y},
                     peaks);
    triangulator.add(
        {sweep.laser, static_cast<std::uint32_t>(peaks.first_row), peaks.position.size(),
         peaks.position.data(), peaks.width.data(), peaks.intensity.data()},
        flange, points);
  }
  std::vector<Eigen::Vector3d> places;
  for (const auto& point : points)
    places.emplace_back(point.x, point.y, point.z);
  return places;
}

std::vector<Eigen::Vector3d> simulated_scan(const scan_cell_sim::Scene& scene,
                                            const scan_cell_common::ScannerModel& scanner,
                                            const std::vector<Sweep>& sweeps) {
  std::vector<Eigen::Vector3d> scan;
  for (const Sweep& sweep : sweeps) {
    const auto points = simulated_scan(scene, scanner, sweep);
    scan.insert(scan.end(), points.begin(), points.end());
  }
  return scan;
}

}  // namespace pass_planner
