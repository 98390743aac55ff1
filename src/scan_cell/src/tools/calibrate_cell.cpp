// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

using scan_cell_msgs::CalibrateResult;

struct Options {
  scan_cell_msgs::CalibrateGoal goal;
  std::vector<std::uint32_t> corners = {15, 25};
  std::vector<int> lasers = {0, 1};
  bool camera_alone = false;
  bool lasers_alone = false;
  double timeout = 10;
};

/// Makes a path absolute, since the cell's working directory is another one.
void make_absolute(std::string& path) {
  if (!path.empty()) path = std::filesystem::absolute(path).lexically_normal().string();
}

scan_cell_msgs::CalibrateGoal goal_of(const Options& options) {
  scan_cell_msgs::CalibrateGoal goal = options.goal;
  for (std::string* path : {&goal.poses, &goal.session, &goal.scanner, &goal.output, &goal.report})
    make_absolute(*path);
  goal.board_columns = options.corners[0];
  goal.board_rows = options.corners[1];
  if (!options.camera_alone) {
    for (const int laser : options.lasers)
      goal.lasers = static_cast<std::uint8_t>(goal.lasers | 1U << laser);
  }
  goal.lasers_alone = static_cast<unsigned char>(options.lasers_alone);
  return goal;
}

void tell(const char* views, const scan_cell_msgs::CalibrationFigures& figures) {
  std::printf("%-9s reprojection %.4f px, board scatter %.3f mm", views,
              figures.reprojection_rms_px, figures.board_scatter_mm);
  for (std::size_t i = 0; i < figures.laser_plane_rms_mm.size(); ++i)
    std::printf("%s %.3f mm", i == 0 ? ", laser planes" : ",", figures.laser_plane_rms_mm[i]);
  std::printf("\n");
}

/// Prints what was recorded and found.
void tell(const scan_cell_msgs::CalibrateGoal& goal, const CalibrateResult& result) {
  for (const std::string& pose : result.skipped)
    std::printf("skipped: %s\n", pose.c_str());
  std::printf("%s: %u of %u poses recorded\n", goal.session.c_str(), result.views, result.poses);
  if (!result.report.empty()) std::printf("report: %s\n", result.report.c_str());
  if (result.held_out.reprojection_rms_px > 0) {
    tell("fitted:", result.fitted);
    tell("held out:", result.held_out);
  }
  for (const std::string& part : result.kept)
    std::printf("kept from %s: %s\n", goal.scanner.c_str(), part.c_str());
  if (result.outcome != CalibrateResult::FINISHED) {
    throw scan_cell_common::Refused("calibration '" + goal.session + "'", "ended early",
                                    result.message);
  }
  if (!result.model.empty()) {
    std::printf("scanner model: %s (%s)\n", result.model.c_str(), result.message.c_str());
  }
}

void calibrate(const Options& options) {
  const scan_cell_msgs::CalibrateGoal goal = goal_of(options);
  ros::NodeHandle node;
  scan_cell::CellClient client(node, {});
  CalibrateResult result;
  {
    scan_cell::ProgressBar bar("calibrate");
    result = client.calibrate(goal, options.timeout, [&bar](const std::string& what, double share) {
      bar.show(what, share);
    });
  }
  tell(goal, result);
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--poses", options.goal.poses, "file of taught poses of the flange")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--session", options.goal.session,
                 "folder to record into; must not hold a session yet")
      ->required();
  app.add_option("--output", options.goal.output,
                 "scanner model (YAML) to write; none: record only");
  app.add_option("--report", options.goal.report, "JSON; report.json in the session if not given");
  app.add_option("--corners", options.corners, "inner corners of the board, along its x and its y")
      ->expected(2)
      ->capture_default_str();
  app.add_option("--square", options.goal.square_size, "[m] of the board")->capture_default_str();
  app.add_option("--scanner", options.goal.scanner,
                 "existing scanner model, used for what is not calibrated again")
      ->check(CLI::ExistingFile);
  CLI::Option* const camera_alone =
      app.add_flag("--camera-alone", options.camera_alone,
                   "calibrate camera and its pose on the flange, no laser");
  app.add_flag("--lasers-alone", options.lasers_alone,
               "calibrate lasers; camera and its pose on the flange are kept from --scanner")
      ->excludes(camera_alone);
  app.add_option("--lasers", options.lasers, "lasers to calibrate; each is on in turn")
      ->check(CLI::Range(0, 1))
      ->capture_default_str()
      ->excludes(camera_alone);
  app.add_option("--board-exposure", options.goal.board_exposure, "[s] lasers off")
      ->capture_default_str();
  app.add_option("--line-exposure", options.goal.line_exposure, "[s] with a laser on")
      ->capture_default_str();
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell")
      ->capture_default_str();
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  options.goal.board_exposure = 0.05;
  options.goal.line_exposure = 0.001;
  options.goal.square_size = 0.02;
  CLI::App app(
      "Moves the running cell's robot to taught poses, records a calibration session, and "
      "computes\n"
      "the scanner model from it.\n"
      "Exit code 0: done; 2: ended early, refused, or no model within the limits; 1: no cell.");
  add_options(app, options);
  return scan_cell_common::ros_tool_main(
      "calibrate_cell", app, argc, argv,
      [&] {
        calibrate(options);
        return 0;
      },
      scan_cell_common::kRefused);
}
