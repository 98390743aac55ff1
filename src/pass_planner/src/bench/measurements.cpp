// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "measurements.h"

#include <algorithm>
#include <cmath>

#include "drawn_parts.h"
#include "pass_planner/sight.h"
#include "scan_cell_common/geometry/point_tree.h"
#include "simulated_scan.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;

constexpr double kNear = 1e-3;  // [m] of a scanned point from a waypoint that was measured

SightParameters as_in_the_cell() {
  SightParameters parameters;
  parameters.region_x = kRegionX;
  parameters.region_y = kRegionY;
  parameters.region_width = kRegionWidth;
  parameters.region_height = kRegionHeight;
  return parameters;
}

}  // namespace

std::vector<double> distances(const std::vector<Vector3d>& places,
                              const std::vector<Vector3d>& scan) {
  std::vector<double> result(places.size(), std::numeric_limits<double>::infinity());
  if (scan.empty()) return result;
  const scan_cell_common::PointTree tree(scan);
  for (std::size_t i = 0; i < places.size(); ++i) {
    scan_cell_common::PointTree::Index index = 0;
    double squared = 0;
    tree.nearest(places[i].data(), 1, &index, &squared);
    result[i] = std::sqrt(squared);
  }
  return result;
}

SightParameters any_angle_in_the_cell() {
  SightParameters parameters = as_in_the_cell();
  parameters.max_light_angle = parameters.max_sight_angle = 1.57;
  return parameters;
}

Agreement measure_agreement(const std::string& scanner, std::uint64_t first_seed, int parts) {
  const auto model = scan_cell_common::load_scanner_model(scanner);
  constexpr double kTolerance = 5e-5;  // [m] of the mesh
  Agreement result;
  for (std::uint64_t seed = first_seed; seed < first_seed + static_cast<std::uint64_t>(parts);
       ++seed) {
    const DrawnPart drawn = draw_part(seed);
    const Surface surface(shape_of(drawn.world.parts.front().mesh(kTolerance)));
    const auto places = places_of(positions_of(drawn.true_path), surface);
    const SightCheck check(model, surface, as_in_the_cell());
    const PathSight sight = look_along(check, sweeps_of({draw_line(seed)}), places);
    const scan_cell_sim::Scene scene(drawn.world);
    const std::vector<Vector3d> scan = simulated_scan(scene, model, sight.sweeps);
    const auto off = distances(positions_of(drawn.true_path), scan);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const bool there = off[i] <= kNear;
      if (sight.best[i].sight == Sight::kSeen) {
        ++result.seen;
        result.seen_and_there += there;
      } else if (sight.best[i].sight == Sight::kGrazing) {
        ++result.grazing;
        result.grazing_and_gone += !there;
      } else {
        ++result.hidden;
        result.hidden_and_gone += !there;
      }
    }
  }
  return result;
}

namespace {

constexpr double kFace = 0.06;        // [m] of the face's side
constexpr double kInner = 0.025;      // [m] from its middle; a margin of 5 mm is left out
constexpr double kThickness = 0.001;  // [m]

scan_cell_sim::Part leaning_face(double lean, double roll) {
  scan_cell_sim::Part box;
  box.name = "face";
  box.shape = scan_cell_sim::BoxShape{{kFace, kFace, kThickness}};
  box.pose = Eigen::Translation3d(0, 0, 0.02) * Eigen::AngleAxisd(-lean, Vector3d::UnitY()) *
             Eigen::AngleAxisd(roll, Vector3d::UnitX()) * Eigen::Translation3d(0, 0, -kThickness);
  return box;
}

std::vector<Vector3d> places_on(const scan_cell_sim::Part& box) {
  std::vector<Vector3d> places;
  for (double x = -kInner; x <= kInner; x += 0.005) {
    for (double y = -kInner; y <= kInner; y += 0.005)
      places.emplace_back(box.pose * Vector3d(x, y, kThickness));
  }
  return places;
}

/// A straight pass over the face.
Sweep sweep_over() {
  scan_cell::ScanPass pass;
  for (const double x : {-0.06, 0.06}) {
    pass.poses.emplace_back(Eigen::Translation3d(x, 0, 0.595) *
                            Eigen::AngleAxisd(M_PI, Vector3d::UnitX()));
  }
  return sweeps_of({pass}).front();
}

/// [m] RMS of the points on the face from it; 0: there are none.
double rms_on(const scan_cell_sim::Part& box, const std::vector<Vector3d>& scan) {
  double squares = 0;
  double count = 0;
  for (const Vector3d& point : scan) {
    const Vector3d on_box = box.pose.inverse() * point;
    if (on_box.head<2>().cwiseAbs().maxCoeff() > kInner) continue;
    squares += std::pow(on_box.z() - kThickness, 2);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

}  // namespace

FaceAtAngle measure_face(const std::string& scanner, double lean, double roll) {
  const auto model = scan_cell_common::load_scanner_model(scanner);
  const scan_cell_sim::Part box = leaning_face(lean, roll);
  const scan_cell_sim::Scene scene({std::nullopt, std::nullopt, {box}});
  const Sweep sweep = sweep_over();
  const Surface surface(shape_of(box.mesh(1e-5)));
  const SightCheck check(model, surface, any_angle_in_the_cell());
  const Sighting middle =
      check.along(sweep, {surface.nearest(box.pose * Vector3d(0, 0, kThickness))}).front();

  FaceAtAngle result;
  result.light_angle = middle.light_angle;
  result.sight_angle = middle.sight_angle;
  const auto scan = simulated_scan(scene, model, sweep);
  result.rms = rms_on(box, scan);
  const auto off = distances(places_on(box), scan);
  result.measured = static_cast<double>(std::count_if(off.begin(), off.end(),
                                                      [](double d) { return d <= kNear; })) /
                    static_cast<double>(off.size());
  return result;
}

}  // namespace pass_planner
