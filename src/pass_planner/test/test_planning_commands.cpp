// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause

/// seen_waypoints and plan_passes as a person runs them, on a box of the simulator whose path goes
/// around its flanks.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drawn_parts.h"
#include "scan_cell/scan_program.h"
#include "scan_cell_common/files/files.h"
#include "tool_paths/tool_path_files.h"

namespace pass_planner {
namespace {

class PlanningCommands : public testing::Test {
 protected:
  PlanningCommands() {
    scan_cell_sim::Part box;
    box.shape = scan_cell_sim::BoxShape{{0.08, 0.06, 0.03}};
    const SurfaceShape shape = shape_of(box.mesh(1e-5));
    std::ofstream mesh(file("box.obj"));
    for (const Eigen::Vector3d& p : shape.points)
      mesh << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (const auto& [a, b, c] : shape.triangles)
      mesh << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    save_path("path.csv", 0.03);
  }

  /// Two lines along x, half way down the flanks.
  /// @param out, height [m] of the lines from the box's axis, over its underside
  static void save_path(const std::string& name, double out, double height = 0.015) {
    tool_paths::ToolPath path;
    path.name = "flanks";
    path.segments = {{"left", {}}, {"right", {}}};
    for (int i = 0; i < 11; ++i) {
      const double x = -0.03 + 0.006 * i;
      for (const int side : {0, 1}) {
        const Eigen::Vector3d at(x, side == 0 ? -out : out, height);
        path.segments[static_cast<std::size_t>(side)].waypoints.push_back(
            {Eigen::Isometry3d(Eigen::Translation3d(at)), {}});
      }
    }
    tool_paths::save_tool_path(file(name), path);
  }

  static std::string file(const std::string& name) {
    return testing::TempDir() + "planning_commands_" + name;
  }

  static int run(const std::string& tool, const std::string& options) {
    const std::string command = tool + " --reference " + file("box.obj") + " --scanner " +
                                SCANNER_FILE +
                                " --region-x 336 --region-y 599 --region-width 1024"
                                " --region-height 512 " +
                                options + " > " + file("said.txt") + " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }

  static int plan(const std::string& options) {
    return run(PLAN_PASSES, options + std::string(" --urdf ") + URDF_FILE + " --cell " + CELL_FILE);
  }

  static int look(const std::string& program) {
    return run(SEEN_WAYPOINTS, "--path " + file("path.csv") + " --program " + program +
                                   " --output " + file("seen.json"));
  }

  static std::string said() { return scan_cell_common::read_file(file("said.txt")); }

  static std::size_t seen() {
    const auto json = nlohmann::json::parse(scan_cell_common::read_file(file("seen.json")));
    std::size_t count = 0;
    for (const auto& one : json["best"])
      count += one["sight"] == "seen";
    return count;
  }
};

TEST_F(PlanningCommands, SayThatASweepAlongTheFlanksDoesNotSeeThem) {
  EXPECT_EQ(look(BOTH_LASERS), 2) << said();
  EXPECT_EQ(seen(), 0U) << said();
}

TEST_F(PlanningCommands, WriteAProgramThatSeesAllOfIt) {
  EXPECT_EQ(plan("--path " + file("path.csv") + " --output " + file("program.yaml")), 0) << said();
  EXPECT_FALSE(scan_cell::load_scan_program(file("program.yaml")).passes.empty());
  EXPECT_EQ(look(file("program.yaml")), 0) << said();
  EXPECT_EQ(seen(), 22U);
}

TEST_F(PlanningCommands, AddPassesToAProgramForWhatItDoesNotSee) {
  EXPECT_EQ(plan("--path " + file("path.csv") + " --program " + BOTH_LASERS + " --output " +
                 file("more.yaml")),
            0)
      << said();
  const auto before = scan_cell::load_scan_program(BOTH_LASERS).passes;
  const auto after = scan_cell::load_scan_program(file("more.yaml")).passes;
  ASSERT_GT(after.size(), before.size());
  EXPECT_EQ(after.front().poses.front().translation(), before.front().poses.front().translation());
  EXPECT_EQ(look(file("more.yaml")), 0) << said();
}

TEST_F(PlanningCommands, RefuseAPathThatIsNotOnThePart) {
  save_path("off.csv", 0.1);
  EXPECT_EQ(plan("--path " + file("off.csv") + " --output " + file("off.yaml")), 1) << said();
  EXPECT_NE(said().find("waypoint"), std::string::npos) << said();
}

TEST_F(PlanningCommands, SayWhatCannotBeSeenAndWriteNoProgram) {
  std::remove(file("none.yaml").c_str());
  save_path("underside.csv", 0.01, 0);
  EXPECT_EQ(plan("--path " + file("underside.csv") + " --output " + file("none.yaml")), 2)
      << said();
  EXPECT_NE(said().find("22 of 22 waypoints"), std::string::npos) << said();
  EXPECT_FALSE(std::ifstream(file("none.yaml")).good());
}

}  // namespace
}  // namespace pass_planner
