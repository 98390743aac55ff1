// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/conversions.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "c4g_driver/collision_scene.h"
#include "pass_planner/tool_path_report.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/files.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "tool_paths/path_options.h"
#include "tool_paths/tool_path_files.h"

namespace {

using namespace pass_planner;
using scan_cell_common::InvalidParameter;
using scan_cell_common::YamlEntry;

struct Options {
  std::string path;
  std::string path_units;
  tool_paths::PathOptions conventions;
  std::string frame = "world";
  std::string cell;
  std::string urdf;
  std::vector<double> start;
  std::string shapes;
  std::string part;
  std::string part_units = "m";
  double part_cell = 0.002;  // [m]
  std::string output;
  std::string turned;
  scan_cell_common::ParameterOptions process;
  scan_cell_common::ParameterOptions limits;
  scan_cell_common::ParameterOptions check;
};

RobotInCell robot_of(const Options& options) {
  RobotInCell robot;
  robot.frame = options.frame;
  robot.urdf = scan_cell_common::read_file(options.urdf);
  robot.base_link_in_world = YamlEntry::load(options.cell)["base_link_in_world"].pose();
  options.limits.read(robot.limits);
  if (!options.start.empty()) robot.start = c4g_driver::Joints(options.start.data());
  return robot;
}

void add_mesh(c4g_driver::CollisionScene& scene, const std::string& file, double metres_per_unit,
              const Eigen::Isometry3d& to_base) {
  const pcl::PolygonMesh mesh = scan_cell_common::load_mesh(file, metres_per_unit);
  scan_cell_common::Cloud cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  std::vector<Eigen::Vector3d> vertices;
  for (const pcl::PointXYZ& point : cloud)
    vertices.push_back(to_base * point.getVector3fMap().cast<double>());
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const pcl::Vertices& face : mesh.polygons)
    triangles.push_back({static_cast<std::size_t>(face.vertices[0]),
                         static_cast<std::size_t>(face.vertices[1]),
                         static_cast<std::size_t>(face.vertices[2])});
  scene.set_part(vertices, triangles);
}

void add_part(c4g_driver::CollisionScene& scene, const Options& options,
              const Eigen::Isometry3d& to_base) {
  const double metres_per_unit = scan_cell_common::metres_per(options.part_units);
  if (scan_cell_common::is_mesh_file(options.part))
    return add_mesh(scene, options.part, metres_per_unit, to_base);
  scan_cell_common::Cloud cloud = scan_cell_common::load_cloud(options.part, metres_per_unit);
  if (const std::size_t removed = scan_cell_common::remove_non_finite(cloud); removed > 0)
    std::printf("%s: left out %zu points that are not finite\n", options.part.c_str(), removed);
  std::vector<Eigen::Vector3d> points;
  for (const pcl::PointXYZ& point : cloud)
    points.push_back(to_base * point.getVector3fMap().cast<double>());
  scene.set_part(points, options.part_cell);
}

/// @return none if there are no shapes
std::unique_ptr<c4g_driver::CollisionScene> scene_of(const Options& options,
                                                     const ToolPathCheck& robot) {
  if (options.shapes.empty()) {
    if (!options.part.empty())
      throw InvalidParameter("--part", options.part,
                             "give --shapes, too: bodies that must not hit it");
    return nullptr;
  }
  auto scene = std::make_unique<c4g_driver::CollisionScene>(
      robot.model(), c4g_driver::read_cell_shapes(options.shapes));
  if (!options.part.empty()) add_part(*scene, options, robot.frame_in_base_link());
  return scene;
}

int check_path(const Options& options) {
  const auto file =
      tool_paths::load_tool_path_file(options.path, options.conventions.typed(options.path_units));
  if (!options.turned.empty() && !file.path.has_orientation)
    throw InvalidParameter("--turned-path", options.turned, "the path has no orientations");
  tool_path_programs::ExportParameters process;
  options.process.read(process);
  c4g_driver::ToolCheckParameters parameters;
  options.check.read(parameters);
  const ToolPathCheck robot(robot_of(options));
  const PathForRobot path =
      path_for_robot(file.path, process, robot.frame_in_base_link(),
                     YamlEntry::load(options.cell)["tool_tip_in_tool0"].pose());
  const auto scene = scene_of(options, robot);
  const c4g_driver::ToolCheck found = robot.check(path, parameters, scene.get());
  const std::string approach = robot.approach_refusal(found, process.joint_speed);
  if (!options.output.empty())
    scan_cell_common::save_text(options.output, tool_check_to_json(path, found, approach));
  std::fputs(summary_of(path, found, approach).c_str(), stdout);
  if (!found.possible() || !approach.empty()) return scan_cell_common::kRefused;
  if (!options.turned.empty())
    tool_paths::save_tool_path(options.turned, turned_path(file.path, path, found.tips),
                               file.layout);
  std::printf("%s: the robot can follow it\n", options.path.c_str());
  return 0;
}

void add_options(CLI::App& app, Options& options, scan_cell_common::Outputs& outputs) {
  const CLI::IsMember units(scan_cell_common::length_units());
  app.add_option("--path", options.path, "tool path: CSV or YAML")->required();
  app.add_option("--path-units", options.path_units, "of the path")->check(units);
  add_path_options(app, options.conventions);
  app.add_option("--frame", options.frame, "of path and part: world or base_link")
      ->capture_default_str();
  app.add_option("--cell", options.cell, "poses of robot and tool: cell.yaml")->required();
  app.add_option("--urdf", options.urdf, "of the robot, as for c4g_driver")->required();
  app.add_option("--start-joints", options.start, "[rad] six, where the robot starts")->expected(6);
  app.add_option("--shapes", options.shapes, "shapes that must not collide: YAML");
  app.add_option("--part", options.part, "mesh (STL, OBJ, PLY) or cloud, in the path's frame");
  app.add_option("--part-units", options.part_units)->check(units)->capture_default_str();
  app.add_option("--part-cell", options.part_cell, "[m] grid cell that a point of a cloud fills")
      ->capture_default_str();
  outputs.add(app, "--output", options.output, "full result: JSON");
  outputs.add(app, "--turned-path", options.turned,
              "the path as turned by --free-about-z, written if the robot can follow it");
  options.process.add(app, tool_path_programs::ExportParameters(),
                      {"waypoint_z", "speed_value", "speed_unit", "speed", "travel_speed",
                       "joint_speed", "zone", "approach", "retract"});
  options.check.add(app, c4g_driver::ToolCheckParameters());
  options.limits.add(app, c4g_driver::RobotLimits(),
                     {"operation", "workspace_min", "workspace_max", "joint_lower", "joint_upper",
                      "max_linear_speed"});
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Tells whether the robot can follow a tool path, and all places where it cannot.\n"
      "Exit code 0: it can; 2: it cannot, and why; 1: unusable input.");
  Options options;
  scan_cell_common::Outputs outputs;
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "check_path", app, argc, argv, [&] { return check_path(options); },
      scan_cell_common::kRefused, outputs);
}
