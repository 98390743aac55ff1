// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "scan_calibration/taught_poses.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/tools/tool_main.h"
#include "teaching/cell_file.h"
#include "teaching/tool_tip.h"
#include "teaching/world_frame.h"

using scan_calibration::TaughtPoses;
using scan_cell_common::UnusableInput;

namespace {

using scan_cell_common::kDegree;

void calibrate_tool(const std::string& poses_file, const std::string& cell_file,
                    const scan_calibration::ToolTipLimits& limits) {
  const TaughtPoses taught = scan_calibration::load_taught_poses(poses_file);
  if (!taught.has_orientation) {
    throw UnusableInput(poses_file, "points without orientation",
                        "give poses of the flange: x,y,z,qx,qy,qz,qw");
  }
  const scan_calibration::ToolTip tool =
      scan_calibration::tool_tip_from_poses(taught.poses, limits);
  const Eigen::Vector3d tip = tool.tip * 1e3;
  const Eigen::Vector3d deviation = tool.deviation * 1e3;
  std::printf("tool_tip_in_tool0: %.3f %.3f %.3f mm, standard deviation %.3f %.3f %.3f mm\n",
              tip.x(), tip.y(), tip.z(), deviation.x(), deviation.y(), deviation.z());
  std::printf("%zu poses, miss %.3f mm rms, %.3f mm at worst (pose %zu), condition number %.1f\n",
              taught.poses.size(), tool.rms * 1e3, tool.worst_residual * 1e3, tool.worst_pose + 1,
              tool.condition);
  scan_calibration::update_cell_entry(cell_file, "tool_tip_in_tool0",
                                      Eigen::Isometry3d(Eigen::Translation3d(tool.tip)));
}

/// Positions of the tip: as taught, or from the flange's pose and the calibrated tool.
std::vector<Eigen::Vector3d> tip_positions(const TaughtPoses& taught,
                                           const std::string& cell_file) {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  if (taught.has_orientation) {
    tip = scan_calibration::load_cell_entry(cell_file, "tool_tip_in_tool0").translation();
  }
  std::vector<Eigen::Vector3d> positions;
  for (const Eigen::Isometry3d& pose : taught.poses)
    positions.push_back(pose * tip);
  return positions;
}

void calibrate_world(const std::string& points_file, const std::string& cell_file,
                     const scan_calibration::WorldFrameLimits& limits) {
  const TaughtPoses taught = scan_calibration::load_taught_poses(points_file);
  if (taught.poses.size() != 3) {
    throw UnusableInput(points_file, fmt::format("{} points", taught.poses.size()),
                        "give three: O, X and XY, in this order");
  }
  const std::vector<Eigen::Vector3d> points = tip_positions(taught, cell_file);
  const scan_calibration::WorldFrame world =
      scan_calibration::world_from_points(points[0], points[1], points[2], limits);
  const Eigen::Isometry3d base = world.pose.inverse();
  std::printf("base_link_in_world: %.4f %.4f %.4f m, z leans %.3f deg, angle O-X-XY %.3f deg\n",
              base.translation().x(), base.translation().y(), base.translation().z(),
              std::acos(std::min(1.0, std::abs(base.linear()(2, 2)))) / kDegree,
              90 + world.skew / kDegree);
  scan_calibration::update_cell_entry(cell_file, "base_link_in_world", base);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds the frames of the cell from taught poses and writes them to cell.yaml.");
  app.require_subcommand(1);
  std::string cell_file = "cell.yaml";
  std::string taught_file;
  app.add_option("--cell", cell_file, "file to write; its other entry is kept")
      ->capture_default_str();

  scan_calibration::ToolTipLimits tool_limits;
  CLI::App* tool = app.add_subcommand("tool", "tool tip from poses that touch one fixed point");
  tool->add_option("--poses", taught_file, "CSV of flange poses in base_link")->required();
  tool->add_option("--max-condition", tool_limits.max_condition)->capture_default_str();
  tool->add_option("--max-residual", tool_limits.max_residual, "[m]")->capture_default_str();

  scan_calibration::WorldFrameLimits world_limits;
  CLI::App* world = app.add_subcommand("world", "world frame from the points O, X and XY");
  world
      ->add_option("--points", taught_file,
                   "CSV of O, X, XY in base_link: tip positions x,y,z, or flange poses "
                   "x,y,z,qx,qy,qz,qw with the tool tip of the cell file")
      ->required();
  world->add_option("--min-distance", world_limits.min_distance, "[m]")->capture_default_str();
  world->add_option("--max-skew", world_limits.max_skew, "[rad]")->capture_default_str();
  scan_cell_common::refuse_renamed(
      *tool, {{"--most-condition", "--max-condition"}, {"--most-residual", "--max-residual"}});
  scan_cell_common::refuse_renamed(
      *world, {{"--least-distance", "--min-distance"}, {"--most-skew", "--max-skew"}});
  for (CLI::App* command : {tool, world})
    command->fallthrough();

  return scan_cell_common::tool_main("cell_frames", app, argc, argv, [&] {
    if (tool->parsed()) calibrate_tool(taught_file, cell_file, tool_limits);
    if (world->parsed()) calibrate_world(taught_file, cell_file, world_limits);
    return 0;
  });
}
