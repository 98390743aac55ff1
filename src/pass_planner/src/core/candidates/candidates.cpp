// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pass_planner/candidates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scan_cell_common/parameters/parameter_table.h"
#include "scan_cell_common/pose/units.h"

namespace pass_planner {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using scan_cell::PassKind;
using scan_cell::ScanPass;
using scan_cell_common::ScannerModel;

using scan_cell_common::kDegree;

// All chosen: in steps of these, angles of incidence change by less than a surface tolerates.
constexpr int kDirections = 8;                          // of travel, over half a turn
constexpr double kLeans[] = {0, -20, 20, -40, 40};      // [deg] of the camera from straight down
constexpr double kHeights[] = {1, 0.85};                // of the stand-off
constexpr double kOverAngles[] = {30, 45};              // [deg] to both sides of an arc over it
constexpr double kRolls[] = {0, -30, 30};               // [deg] of an arc over the part
constexpr double kAroundLeans[] = {25, 40, 50};         // [deg] of the camera from straight down
constexpr double kAroundSpans[] = {90, 180, 270, 340};  // [deg] of an arc around the part
constexpr int kAroundStarts = 8;                        // over a whole turn

/// [m] from the camera to where the lasers' planes cross its axis, on average.
double crossing_of(const ScannerModel& scanner) {
  double sum = 0, count = 0;
  for (const auto& laser : scanner.lasers) {
    if (!laser) continue;
    sum += laser->distance / laser->normal.z();
    ++count;
  }
  return sum / count;
}

/// The places that a candidate should pass over.
class Target {
 public:
  Target(const std::vector<Surface::Place>& places, const ScannerModel& scanner,
         const PlanParameters& parameters)
      : places_(places), scanner_(scanner), parameters_(parameters) {
    Eigen::AlignedBox3d box;
    for (const Surface::Place& place : places)
      box.extend(place.point);
    middle = box.center();
  }

  /// [m] least and greatest coordinate of the places along a direction, from their middle.
  std::pair<double, double> extent(const Vector3d& direction) const {
    std::pair<double, double> ends = {0, 0};
    for (const Surface::Place& place : places_) {
      const double at = direction.dot(place.point - middle);
      ends = {std::min(ends.first, at), std::max(ends.second, at)};
    }
    return ends;
  }

  /// [m] the camera's first and last position along `travel` so that all lasers pass over all
  /// places, with the margin.
  /// @param camera position 0
  std::pair<double, double> way(const Isometry3d& camera, const Vector3d& travel) const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const auto& laser : scanner_.lasers) {
      if (!laser) continue;
      const Vector3d normal = camera.linear() * laser->normal;
      for (const Surface::Place& place : places_) {
        const double off = normal.dot(place.point - camera.translation()) - laser->distance;
        const double at = off / normal.dot(travel);
        least = std::min(least, at);
        most = std::max(most, at);
      }
    }
    return {least - parameters_.margin, most + parameters_.margin};
  }

  Isometry3d flange_of(const Isometry3d& camera) const {
    return camera * scanner_.flange_to_camera.inverse();
  }

  ScanPass pass(const std::string& name, PassKind kind,
                const std::vector<Isometry3d>& cameras) const {
    ScanPass result;
    result.name = name;
    result.kind = kind;
    for (const Isometry3d& camera : cameras)
      result.poses.push_back(flange_of(camera));
    result.speed = parameters_.speed;
    result.rate = parameters_.rate;
    return result;
  }

  Vector3d middle;  // [m] of the places

 private:
  const std::vector<Surface::Place>& places_;
  const ScannerModel& scanner_;
  const PlanParameters& parameters_;
};

/// Camera looking straight down, x along the direction of travel [rad about z].
Matrix3d looking_down(double direction) {
  return (AngleAxisd(direction, Vector3d::UnitZ()) * AngleAxisd(M_PI, Vector3d::UnitX()))
      .toRotationMatrix();
}

/// Camera looking at a point from a distance along its axis.
Isometry3d looking_at(const Vector3d& point, const Matrix3d& camera, double distance) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = camera;
  pose.translation() = point - distance * camera.col(2);
  return pose;
}

/// Middles of lanes side by side, as many as the places need.
/// @param width [m] of a lane
std::vector<double> lanes(const std::pair<double, double>& extent, double width) {
  const double whole = extent.second - extent.first;
  const double count = std::max(1.0, std::ceil(whole / width));
  std::vector<double> result;
  for (double lane = 0; lane < count; ++lane)
    result.push_back(extent.first + whole * (lane + 0.5) / count);
  return result;
}

void add_lines(const Target& target, double stand_off, double lane, std::vector<ScanPass>& passes) {
  for (int step = 0; step < kDirections; ++step) {
    const double direction = M_PI * step / kDirections;
    const Matrix3d down = looking_down(direction);
    const Vector3d travel = down.col(0);
    for (const double pitch : kLeans) {
      for (const double roll : kLeans) {
        const Matrix3d camera = down * AngleAxisd(roll * kDegree, Vector3d::UnitX()) *
                                AngleAxisd(pitch * kDegree, Vector3d::UnitY());
        for (const double beside : lanes(target.extent(down.col(1)), lane)) {
          const Vector3d at = target.middle + beside * down.col(1);
          const Isometry3d start = looking_at(at, camera, stand_off);
          const auto [first, last] = target.way(start, travel);
          passes.push_back(target.pass(
              fmt::format("line at {:g} degrees, leaning by {:g} along it and {:g} across",
                          direction / kDegree, pitch, roll),
              PassKind::kLine,
              {Eigen::Translation3d(first * travel) * start,
               Eigen::Translation3d(last * travel) * start}));
        }
      }
    }
  }
}

/// Arcs on which the camera looks at a point below the part, so that it sees each side of it from
/// that side.
void add_arcs_over(const Target& target, double stand_off, double margin,
                   std::vector<ScanPass>& passes) {
  for (int step = 0; step < kDirections; ++step) {
    const double direction = M_PI * step / kDirections;
    const Matrix3d down = looking_down(direction);
    const auto [first, last] = target.extent(down.col(0));
    const double half = std::max(-first, last) + margin;
    for (const double angle : kOverAngles) {
      const double below = half / std::tan(angle * kDegree);
      for (const double roll : kRolls) {
        const Matrix3d middle = down * AngleAxisd(roll * kDegree, Vector3d::UnitX());
        const Vector3d centre = target.middle + below * middle.col(2);
        std::vector<Isometry3d> cameras;
        for (const double turn : {angle, 0.0, -angle}) {
          cameras.push_back(looking_at(
              centre, middle * AngleAxisd(turn * kDegree, Vector3d::UnitY()), stand_off + below));
        }
        passes.push_back(
            target.pass(fmt::format("arc over the part at {:g} degrees, leaning by {:g} across",
                                    direction / kDegree, roll),
                        PassKind::kArc, cameras));
      }
    }
  }
}

/// Arcs on which the camera goes around the part and looks at its middle. The line of light lies
/// across the direction of travel.
void add_arcs_around(const Target& target, double stand_off, std::vector<ScanPass>& passes) {
  for (const double lean : kAroundLeans) {
    for (const double span : kAroundSpans) {
      for (int start = 0; start < kAroundStarts; ++start) {
        const double first = 360.0 * start / kAroundStarts;
        std::vector<Isometry3d> cameras;
        for (const double share : {0.0, 0.5, 1.0}) {
          // Seen from above, the camera is at `side` of the part and moves to the left from there.
          const double side = first + share * span;
          const Matrix3d camera =
              looking_down((side + 90) * kDegree) * AngleAxisd(lean * kDegree, Vector3d::UnitX());
          cameras.push_back(looking_at(target.middle, camera, stand_off));
        }
        passes.push_back(target.pass(
            fmt::format("arc around the part from {:g} over {:g} degrees, leaning by {:g}", first,
                        span, lean),
            PassKind::kArc, cameras));
      }
    }
  }
}

}  // namespace

void describe(scan_cell_common::ParameterTable& table, PlanParameters& parameters) {
  table.add("max_passes", parameters.max_passes, {1, 200}, "largest number of passes to propose");
  table.add("good_angle", parameters.good_angle, {0.1, 1.57, "rad"},
            "largest angle of light and sight to the surface's normal, where that is possible");
  table.add("margin", parameters.margin, {0, 0.5, "m"},
            "length of a pass beyond the outermost waypoints");
  table.add("clearance", parameters.clearance, {0, 1, "m"},
            "of flange, camera and lasers from the part and the floor");
  table.add("floor_height", parameters.floor_height, {-10, 10, "m"}, "z of the floor in `world`");
  table.add("stand_off", parameters.stand_off, {0.05, 5, "m", scan_cell_common::Also::kZero},
            "of the camera; 0: where the planes of light cross its axis");
  table.add("speed", parameters.speed, {1e-3, 0.5, "m/s"}, "of the passes");
  table.add("rate", parameters.rate, {2, 250, "Hz"}, "frames per second of each laser");
}

std::vector<ScanPass> candidate_passes(const std::vector<Surface::Place>& places,
                                       const ScannerModel& scanner, const SightParameters& image,
                                       const PlanParameters& parameters) {
  const Target target(places, scanner, parameters);
  const double far = parameters.stand_off > 0 ? parameters.stand_off : crossing_of(scanner);
  const int rows = image.region_height > 0 ? image.region_height : scanner.camera.height;
  std::vector<ScanPass> passes;
  for (const double height : kHeights) {
    const double stand_off = height * far;
    constexpr double kUsed = 0.8;  // of the line's length in the image; chosen
    add_lines(target, stand_off, kUsed * stand_off * rows / scanner.camera.fy, passes);
    add_arcs_over(target, stand_off, parameters.margin, passes);
    add_arcs_around(target, stand_off, passes);
  }
  return passes;
}

}  // namespace pass_planner
