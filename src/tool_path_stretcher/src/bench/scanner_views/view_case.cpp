// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scanner_views/view_case.h"

#include <algorithm>
#include <limits>

#include "cloud_preprocess/clean.h"
#include "geometry/kd_tree.h"
#include "parts/scan.h"
#include "scan_cell_common/errors/errors.h"

namespace scanner_views {
namespace {

using Eigen::Vector3d;

ScanPoints chosen(const ScanPoints& points, const std::vector<std::uint32_t>& which,
                  const scan_cell_common::Cloud& places) {
  ScanPoints result;
  for (std::size_t i = 0; i < which.size(); ++i) {
    result.places.emplace_back(places[i].getVector3fMap().cast<double>());
    result.seen_from.push_back(points.seen_from[which[i]]);
    result.lasers.push_back(points.lasers[which[i]]);
    result.passes.push_back(points.passes[which[i]]);
    result.surfaces.push_back(points.surfaces[which[i]]);
  }
  return result;
}

/// Cleans with the default parameters of clean_cloud.
void clean(View& view) {
  view.scan = view.object;
  scan_cell_common::Cloud cloud;
  for (const Vector3d& place : view.object.places) {
    const Eigen::Vector3f at = place.cast<float>();
    cloud.push_back({at.x(), at.y(), at.z()});
  }
  cloud_preprocess::TracedCloud traced(cloud);
  std::vector<cloud_preprocess::StageReport> reports;
  try {
    cloud_preprocess::clean(traced, {}, reports);
  } catch (const scan_cell_common::Error& error) {
    view.not_cleaned = error.what();
    return;
  }
  view.object = chosen(view.object, traced.sources(), traced.cloud());
}

/// The places that a scan shows.
class Coverage {
 public:
  Coverage(const ScanPoints& points, double radius) : radius_(radius), tree_(of_part(points)) {}

  bool shows(const Vector3d& place) const {
    return !tree_.points().empty() && tree_.nearest(place).squared_distance <= radius_ * radius_;
  }

 private:
  /// The points of the part, without its surroundings.
  static Points of_part(const ScanPoints& points) {
    Points result;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
      if (points.surfaces[i] == 0) result.push_back(points.places[i]);
    }
    return result;
  }

  double radius_;
  tool_path_stretcher::KdTree tree_;
};

/// Whether a tool of 10 mm that comes from above would meet a clamp.
class Obstacles {
 public:
  explicit Obstacles(const ScanPoints& points) : tree_(around_part(points)) {}

  bool block(const Eigen::Isometry3d& tool) const {
    constexpr double kHigh = 0.04, kLow = 0.001, kWide = 0.005;  // [m]
    std::vector<tool_path_stretcher::KdTree::Neighbour> near;
    tree_.within(tool.translation(), kHigh, near);
    const Vector3d normal = tool.linear().col(2);
    return std::any_of(near.begin(), near.end(), [&](const auto& neighbour) {
      const Vector3d way = tree_.points()[neighbour.index] - tool.translation();
      const double height = way.dot(normal);
      return height > kLow && (way - height * normal).norm() < kWide;
    });
  }

 private:
  static Points around_part(const ScanPoints& points) {
    constexpr auto kScattered = std::numeric_limits<unsigned>::max();
    Points result;
    for (std::size_t i = 0; i < points.places.size(); ++i) {
      const unsigned surface = points.surfaces[i];
      if (surface != 0 && surface != kScattered) result.push_back(points.places[i]);
    }
    return result;
  }

  tool_path_stretcher::KdTree tree_;
};

/// The path where both scans show it and nothing is in the tool's way, that is, where a person
/// would expect it to be adapted.
ToolPath shown_path(const ViewCase& each, const View& view) {
  constexpr double kNear = 0.003;  // [m] two and a half lines
  const double radius = kNear * coarseness_of(each.object.mesh);
  const Obstacles obstacles(view.object);
  const Coverage object(view.object, radius), reference(view.reference_scan, radius);
  return parted(view.path, [&](const tool_path_stretcher::Waypoint& waypoint) {
    const Vector3d& at = waypoint.pose.translation();
    Eigen::Isometry3d lying = Eigen::Isometry3d::Identity();
    lying.linear() = each.similarity.rotation * waypoint.pose.linear();
    lying.translation() = each.similarity * each.deformation(at);
    return object.shows(lying.translation()) && !obstacles.block(lying) &&
           (!each.reference_scanned || reference.shows(at));
  });
}

/// Keeps the shown part of the path, or, if there is none, of another kind of path.
void keep_what_is_shown(const ViewCase& each, Draws& draws, View& view) {
  ToolPath shown = shown_path(each, view);
  for (const PathKind kind : {PathKind::kRaster, PathKind::kRim, PathKind::kWave}) {
    if (!shown.segments.empty()) break;
    view.path = path_on(each.reference.mesh, kind, draws);
    shown = shown_path(each, view);
  }
  view.path = shown;
}

void move(const Eigen::Isometry3d& frame, View& view) {
  for (ScanPoints* points : {&view.object, &view.scan}) {
    for (Vector3d& place : points->places)
      place = frame * place;
    for (Vector3d& eye : points->seen_from)
      eye = frame * eye;
  }
  for (auto& segment : view.truth.segments) {
    for (auto& waypoint : segment.waypoints)
      waypoint.pose = frame * waypoint.pose;
  }
}

/// The object in its pose, meshed finely enough for its deformation.
Mesh lying_object(const ViewCase& each) {
  constexpr double kFine = 120;  // edges across the part: 2 mm of 250 mm; chosen
  return moved(
      refined(each.object.mesh, extent_of(each.object.mesh) / kFine),
      [&](const Vector3d& at) -> Vector3d { return each.similarity * each.deformation(at); });
}

}  // namespace

View view_of(const ViewCase& each) {
  Draws draws(each.seed);
  View view;
  view.path = each.reference.path.segments.empty() ? path_on(each.reference.mesh, each.path, draws)
                                                   : each.reference.path;
  if (each.reference_scanned) {
    view.reference_scan = scan({each.reference.mesh}, {Viewing::kTwoSides}, draws);
  } else {
    view.reference_mesh = to_polygon_mesh(each.reference.mesh);
  }
  std::vector<Mesh> meshes = {lying_object(each)};
  const Mesh alike = moved(
      each.object.mesh, [&](const Vector3d& at) -> Vector3d { return each.similarity.scale * at; });
  for (Mesh& mesh : meshes_of(each.surroundings, meshes.front(), alike, draws))
    meshes.push_back(std::move(mesh));
  constexpr double kAround = 0.05;  // [m] of the scene, scanned with the part
  view.object = scan(meshes, {each.viewing, meshes.size() > 1 ? kAround : 0}, draws);
  scatter(each.scattered, meshes.front(), draws, view.object);
  view.scanned = view.object.places.size();
  if (each.expected == Reason::kAccepted && !each.whole_path) keep_what_is_shown(each, draws, view);
  view.truth = cases::truth(view.path, each.deformation, each.similarity);
  if (each.cleaned) clean(view);
  move(each.frame, view);
  return view;
}

}  // namespace scanner_views
