// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "cures.h"

#include <pcl/conversions.h>

#include <algorithm>

#include "cloud_preprocess/clean.h"
#include "drawn_parts.h"
#include "pass_planner/plan.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_sim/cell.h"
#include "simulated_scan.h"
#include "tool_path_stretcher/stretcher.h"

namespace pass_planner {
namespace {

using Eigen::Vector3d;
using scan_cell_common::Cloud;
using tool_path_stretcher::StretchResult;

constexpr double kTolerance = 5e-5;  // [m] of the reference's mesh

pcl::PolygonMesh polygons_of(const scan_cell_sim::Mesh& mesh) {
  Cloud corners;
  for (const Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3f at = vertex.cast<float>();
    corners.push_back({at.x(), at.y(), at.z()});
  }
  pcl::PolygonMesh polygons;
  pcl::toPCLPointCloud2(corners, polygons.cloud);
  for (const auto& triangle : mesh.triangles) {
    pcl::Vertices face;
    face.vertices = {static_cast<pcl::index_t>(triangle[0]), static_cast<pcl::index_t>(triangle[1]),
                     static_cast<pcl::index_t>(triangle[2])};
    polygons.polygons.push_back(face);
  }
  return polygons;
}

tool_path_stretcher::ToolPath tool_path_of(const scan_cell_sim::ToolPath& poses) {
  tool_path_stretcher::ToolPath path;
  path.has_orientation = true;
  path.segments.emplace_back();
  for (const Eigen::Isometry3d& pose : poses)
    path.segments.front().waypoints.push_back({pose, {}});
  return path;
}

/// One trial, step by step.
class Trial {
 public:
  Trial(const CellFiles& files, std::uint64_t seed)
      : scanner_(scan_cell_common::load_scanner_model(files.scanner)),
        drawn_(draw_part(seed)),
        mesh_(drawn_.reference.mesh(kTolerance)),
        reference_(tool_path_stretcher::surface_from_mesh(polygons_of(mesh_), parameters_.leaf,
                                                          "reference")),
        scene_(drawn_.world) {
    robot_.urdf = scan_cell_common::read_file(files.urdf);
    robot_.base_link_in_world = scan_cell_sim::load_base_link_in_world(files.cell);
    // Boxes look the same when turned, so a person says roughly how the part lies.
    std::mt19937_64 random(seed);
    tool_path_stretcher::PosePrior prior;
    prior.pose = drawn_.world.parts.front().pose *
                 Eigen::Translation3d(draw(random, -0.01, 0.01), draw(random, -0.01, 0.01), 0) *
                 Eigen::AngleAxisd(draw(random, -0.2, 0.2), Vector3d::UnitZ());
    parameters_.prior.pose = prior;
  }

  const DrawnPart& drawn() const { return drawn_; }

  void scan(const scan_cell::ScanPass& pass) {
    for (const Sweep& sweep : sweeps_of({pass})) {
      const auto points = simulated_scan(scene_, scanner_, sweep);
      scan_.insert(scan_.end(), points.begin(), points.end());
    }
  }

  /// @throw scan_cell_common::UnusableInput if nothing is left of the cloud
  StretchResult adapt() const {
    Cloud cloud;
    for (const Vector3d& point : scan_) {
      const Eigen::Vector3f at = point.cast<float>();
      cloud.push_back({at.x(), at.y(), at.z()});
    }
    std::vector<cloud_preprocess::StageReport> reports;
    const Cloud cleaned = cloud_preprocess::clean(cloud, {}, reports);
    const auto object = tool_path_stretcher::surface_from_cloud(
        tool_path_stretcher::to_points(cleaned), parameters_.leaf, "scan");
    return stretch(reference_, object, tool_path_of(drawn_.path), parameters_);
  }

  PassPlan plan(const StretchResult& refused, int max_passes) const {
    const Surface surface(placed(shape_of(mesh_), refused.similarity));
    std::vector<Vector3d> wanted;
    const auto positions = positions_of(drawn_.path);
    for (const std::size_t waypoint : refused.verdict.waypoints)
      wanted.push_back(refused.similarity * positions[waypoint]);
    PlanParameters parameters;
    parameters.max_passes = max_passes;
    SightParameters sight;
    sight.region_x = kRegionX;
    sight.region_y = kRegionY;
    sight.region_width = kRegionWidth;
    sight.region_height = kRegionHeight;
    return plan_passes(scanner_, surface, places_of(wanted, surface), sight, Reach(robot_),
                       parameters);
  }

 private:
  const scan_cell_common::ScannerModel scanner_;
  tool_path_stretcher::StretchParameters parameters_;
  const DrawnPart drawn_;
  const scan_cell_sim::Mesh mesh_;
  const tool_path_stretcher::Surface reference_;
  const scan_cell_sim::Scene scene_;
  RobotInCell robot_;
  std::vector<Vector3d> scan_;
};

}  // namespace

CureTrial run_cure(const CellFiles& files, std::uint64_t seed) {
  Trial trial(files, seed);
  CureTrial result;
  result.part = trial.drawn().name;
  result.waypoints = trial.drawn().path.size();
  trial.scan(draw_line(seed));
  try {
    const StretchResult first = trial.adapt();
    result.first_verdict = to_string(first.verdict.reason);
    result.not_scanned = first.verdict.reason == tool_path_stretcher::Reason::kPathNotScanned;
    if (!result.not_scanned) return result;
    result.missing = first.verdict.waypoints.size();
    const PassPlan plan = trial.plan(first, 1);
    if (!plan.left.empty()) {
      result.why = plan.why.front();
      constexpr int kMany = 20;
      const PassPlan whole = trial.plan(first, kMany);
      result.passes = whole.left.empty() ? whole.passes.size() : 0;
    }
    if (plan.passes.empty()) return result;
    result.pass = plan.passes.front().name;
    trial.scan(plan.passes.front());
    const StretchResult second = trial.adapt();
    result.cured = second.verdict.accepted();
    result.second_verdict = to_string(second.verdict.reason);
    if (!result.cured) result.why += " " + second.verdict.message;
  } catch (const scan_cell_common::UnusableInput& error) {
    (result.first_verdict.empty() ? result.first_verdict : result.second_verdict) = error.what();
  }
  return result;
}

}  // namespace pass_planner
