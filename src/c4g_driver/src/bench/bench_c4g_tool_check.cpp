// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

// The check of a whole tool path, compared with KDL's own numeric solver (ChainIkSolverPos_LMA),
// which only finds the joints at the same waypoints, each from those at the one before.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <kdl/chainiksolverpos_lma.hpp>

#include "c4g_driver/collision_scene.h"
#include "c4g_driver/tool_motion_check.h"
#include "robot/smart5_six.h"
#include "scan_cell_common/tools/tool_main.h"

using namespace c4g_driver;  // NOLINT
using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

namespace {

constexpr double kGoal = 1;  // [s] for 2,000 waypoints

RobotState standing() {
  RobotState state;
  state.mode = ControllerMode::kRemote;
  state.joints = degrees(0, 8, -124, 0, 48, 0);
  state.flange = smart5_six().flange_at(state.joints);
  return state;
}

/// Lines across a waved part, with the tool tilted like its surface.
/// @param farther [m] distance beyond the place where the robot can follow
ToolMotion path_of(int count, double farther) {
  ToolMotion motion;
  motion.flange_to_tip = Isometry3d(Translation3d(0.03, 0, 0.2));
  for (int i = 0; i < count; ++i) {
    const double along = 2.0 * i / count;  // [m] in lines of 0.4 m
    const int line = static_cast<int>(along / 0.4);
    const double y = line % 2 == 0 ? along - 0.4 * line - 0.2 : 0.2 - (along - 0.4 * line);
    ToolWaypoint waypoint;
    waypoint.tip = looking_down(0.7 + farther + 0.05 * line, y, 0.3 + 0.02 * std::sin(20 * y)) *
                   AngleAxisd(0.3 * std::cos(20 * y), Vector3d::UnitX());
    motion.waypoints.push_back(waypoint);
  }
  return motion;
}

CellShapes shapes() {
  using Kind = CellShape::Kind;
  CellShapes shapes;
  shapes.shapes = {
      {"bracket", "flange", Kind::kBox, {0.6, 0.04, 0.04}, Isometry3d(Translation3d(0, 0, 0.03))},
      {"camera", "flange", Kind::kSphere, {0.06, 0, 0}, Isometry3d(Translation3d(0, 0, 0.08))},
      {"tool", "tool_tip", Kind::kCapsule, {0.01, 0.05, 0}, Isometry3d(Translation3d(0, 0, -0.03))},
      {"floor", "base_link", Kind::kHalfSpace, {0, 0, 1}, Isometry3d(Translation3d(0, 0, -0.1))},
      {"table", "base_link", Kind::kBox, {0.6, 1, 0.1}, Isometry3d(Translation3d(0.9, 0, 0.15))},
      {"clamp",
       "base_link",
       Kind::kBox,
       {0.1, 0.1, 0.1},
       Isometry3d(Translation3d(0.8, 0.35, 0.3))}};
  shapes.links = {{"link_2", 0.1}, {"link_3", 0.1}, {"link_4", 0.08}};
  return shapes;
}

/// The part's surface as points 2 mm apart.
std::vector<Vector3d> part() {
  std::vector<Vector3d> points;
  for (double x = 0.6; x < 1; x += 0.002) {
    for (double y = -0.25; y < 0.25; y += 0.002)
      points.emplace_back(x, y, 0.3 + 0.02 * std::sin(20 * y));
  }
  return points;
}

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// @return [s] of KDL's solver for the same waypoints
double yardstick(const ToolMotion& motion, const Joints& start) {
  const Joints weights = (Joints() << 1, 1, 1, 0.1, 0.1, 0.1).finished();
  KDL::ChainIkSolverPos_LMA solver(smart5_six().chain(), weights);
  const Isometry3d tip_to_flange = motion.flange_to_tip.inverse();
  KDL::JntArray joints = to_kdl(start);
  return seconds_of([&] {
    for (const ToolWaypoint& waypoint : motion.waypoints) {
      KDL::JntArray next(6);
      solver.CartToJnt(joints, to_kdl(waypoint.tip * tip_to_flange), next);
      joints = next;
    }
  });
}

class Bench {
 public:
  explicit Bench(int count) : motion_(path_of(count, 0)), from_(standing()) {
    limits_.operation = Operation::kAutomatic;
    limits_ = narrowed(limits_, smart5_six());
    yardstick_ = yardstick(motion_, from_.joints);
    std::printf("  %-44s %7.3f s\n", "KDL's solver, joints at the waypoints alone", yardstick_);
  }

  /// Moves the path so far away that the robot cannot follow it.
  void move_away() { motion_ = path_of(static_cast<int>(motion_.waypoints.size()), 0.6); }

  void run(const char* what, bool free_about_z, const CollisionScene* scene) const {
    ToolCheckParameters parameters;
    parameters.free_about_z = free_about_z;
    ToolCheck found;
    const double seconds = seconds_of([&] {
      found = check_tool_motion(smart5_six(), limits_, from_, motion_, parameters, scene);
    });
    std::printf("  %-44s %7.3f s   %5.2f times the solver; goal %g s; %s\n", what, seconds,
                seconds / yardstick_, kGoal * static_cast<double>(motion_.waypoints.size()) / 2000,
                found.possible() ? "possible" : found.refusal().c_str());
  }

 private:
  ToolMotion motion_;
  RobotState from_;
  RobotLimits limits_;
  double yardstick_;
};

int measure(int count) {
  std::printf("check of a path of %d waypoints over 2 m\n", count);
  Bench bench(count);
  CollisionScene scene(smart5_six(), shapes());
  bench.run("check", false, nullptr);
  bench.run("check, 9 shapes", false, &scene);
  const std::vector<Vector3d> points = part();
  scene.set_part(points, 0.002);
  bench.run("check, 9 shapes and a part of 50,000 points", false, &scene);
  bench.run("free turn", true, nullptr);
  bench.run("free turn, 9 shapes and the part", true, &scene);
  bench.move_away();
  bench.run("check, much of it out of reach", false, nullptr);
  bench.run("free turn, much of it out of reach", true, nullptr);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  int count = 2000;
  CLI::App app("The check of a path of the tool.");
  app.add_option("--waypoints", count)->check(CLI::Range(2, 1000000))->capture_default_str();
  return scan_cell_common::tool_main("bench_c4g_tool_check", app, argc, argv,
                                     [&] { return measure(count); });
}
