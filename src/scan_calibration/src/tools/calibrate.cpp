// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/core.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <opencv2/core.hpp>

#include "scan_calibration/calibration_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/parameters/parameter_options.h"
#include "scan_cell_common/tools/tool_main.h"

namespace {

using namespace scan_calibration;

using scan_cell_common::kRefused;

constexpr int kPassed = 0;

struct Options {
  std::string session;
  CalibrationFiles files;
  ObservationOptions observation;
  CalibrationOptions calibration;
  CalibrationLimits limits;
  std::vector<double> projectors;
  std::string existing;
  bool camera_alone = false;
  std::vector<std::size_t> lasers;
};

void add_files(CLI::App& app, Options& options) {
  app.add_option("--session", options.session, "folder of session.yaml, poses and images")
      ->required();
  app.add_option("--output", options.files.scanner, "scanner model: YAML")->required();
  app.add_option("--report", options.files.report, "report: JSON; an HTML page goes beside it")
      ->required();
  app.add_option("--camera-info", options.files.camera_info,
                 "the camera for ROS: YAML; default: beside the scanner model");
}

/// Options: what to calibrate, and where the rest comes from.
void add_parts(CLI::App& app, Options& options) {
  const auto add = [&](CLI::Option* option) { return option->group("What to calibrate"); };
  add(app.add_option("--scanner", options.existing,
                     "existing scanner model; supplies what is not calibrated again"))
      ->check(CLI::ExistingFile);
  CLI::Option* const camera = add(app.add_flag("--camera-alone", options.camera_alone,
                                               "camera and its pose on the flange, no laser"));
  CLI::Option* const lasers =
      add(app.add_flag("--lasers-alone", options.calibration.lasers_alone,
                       "laser planes; camera and its pose on the flange are kept from --scanner"));
  add(app.add_option("--lasers", options.lasers,
                     "lasers of the session, such as 0 1; default: all"))
      ->excludes(camera);
  camera->excludes(lasers);
}

void add_limits(CLI::App& app, CalibrationLimits& limits) {
  const auto add = [&](const char* name, double& limit, const char* what) {
    app.add_option(name, limit, what)->check(CLI::PositiveNumber)->group("Limits");
  };
  add("--max-reprojection", limits.reprojection_rms_px, "of held-out views [px RMS]");
  add("--max-plane-rms", limits.laser_plane_rms_mm, "of every laser, held-out views [mm RMS]");
  add("--max-board-scatter", limits.board_scatter_mm, "of held-out views [mm RMS]");
  add("--max-point-deviation", limits.point_deviation_mm,
      "of every point in the report [mm, standard deviation]");
  scan_cell_common::refuse_renamed(app, {{"--most-reprojection", "--max-reprojection"},
                                         {"--most-plane-rms", "--max-plane-rms"},
                                         {"--most-board-scatter", "--max-board-scatter"},
                                         {"--most-point-deviation", "--max-point-deviation"}});
}

void add_knowledge(CLI::App& app, Options& options) {
  CalibrationOptions& known = options.calibration;
  const auto add = [&](const char* name, double& value, const char* what) {
    app.add_option(name, value, what)->capture_default_str()->group("Known in advance");
  };
  add("--corner-deviation", known.corner_deviation, "of a corner [px]; 0: estimated");
  add("--line-deviation", known.line_deviation, "of a laser point [px]; 0: estimated");
  add("--robot-deviation", known.robot_deviation, "of the flange [m]; 0: estimated");
  add("--robot-angle-deviation", known.robot_angle_deviation, "of the flange [rad]; 0: estimated");
  app.add_option("--projector", options.projectors,
                 "position of each laser's projector in camera_optical_frame: x y z [m] per laser")
      ->group("Known in advance");
  app.add_flag("--board-flatness,!--flat-board", known.board_flatness,
               "the board may be bent (default; used if it explains held-out views better), or is "
               "flat");
  app.add_option("--folds", known.folds, "groups of views, held out in turn")
      ->capture_default_str();
  app.add_option("--detector", options.observation.detector,
                 "of the laser line: threshold, center_of_gravity, fir_derivative")
      ->capture_default_str();
  app.add_option("--threads", known.threads, "number of threads; does not change the result")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

/// Prints progress on one line of a terminal; in a log, a line per tenth.
void print_progress(const std::string& what, int done, int total) {
  if (isatty(STDERR_FILENO) != 0) {
    std::fprintf(stderr, "\r%s: %d of %d%s", what.c_str(), done, total, done == total ? "\n" : "");
  } else if (done == total || done * 10 / total != (done - 1) * 10 / total) {
    std::fprintf(stderr, "%s: %d of %d\n", what.c_str(), done, total);
  }
}

void complete(Options& options) {
  if (options.projectors.size() % 3 != 0) {
    throw scan_cell_common::InvalidParameter("projector",
                                             fmt::format("{} numbers", options.projectors.size()),
                                             "give x y z for each laser");
  }
  for (std::size_t i = 0; i < options.projectors.size(); i += 3)
    options.calibration.projectors.emplace_back(
        Eigen::Map<Eigen::Vector3d>(&options.projectors[i]));
  if (!options.existing.empty())
    options.calibration.existing = load_existing_scanner(options.existing);
  if (options.camera_alone || !options.lasers.empty()) options.observation.lasers.emplace();
  std::sort(options.lasers.begin(), options.lasers.end());
  for (const std::size_t laser : options.lasers)
    options.observation.lasers->push_back(scan_cell_common::laser_name(laser));
  options.observation.threads = options.calibration.threads;
  options.observation.progress = print_progress;
  options.calibration.progress = [](const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
  };
  if (options.files.camera_info.empty())
    options.files.camera_info = camera_info_file(options.files.scanner);
  check_writable(options.files);  // before minutes of work, not after
}

void print_figures(const CalibrationRun& run) {
  const Calibration& joint = *run.calibration;
  std::printf("%zu of %d views used; %zu views or lines rejected\n", joint.views.size(), run.taken,
              joint.rejected.size());
  std::printf("%-34s %8s %8s   %s\n", "", "fitted", "held out", "step by step");
  const auto print = [&](const std::string& name, const auto& value) {
    std::printf("%-34s %8.3f %8.3f   %8.3f %8.3f\n", name.c_str(), value(joint.fitted),
                value(joint.held_out), value(run.sequential->fitted),
                value(run.sequential->held_out));
  };
  print("reprojection [px RMS]", [](const Figures& f) { return f.reprojection_rms_px; });
  for (std::size_t i = 0; i < run.observations.lasers.size(); ++i) {
    print("plane of " + run.observations.lasers[i] + " [mm RMS]",
          [i](const Figures& f) { return f.laser_plane_rms_mm.at(i); });
  }
  print("scatter of the board [mm RMS]", [](const Figures& f) { return f.board_scatter_mm; });
  for (const std::string& part : joint.kept)
    std::printf("kept from %s: %s\n", run.existing->file.c_str(), part.c_str());
  for (const std::string& note : joint.notes)
    std::printf("note: %s\n", note.c_str());
  if (!joint.advice.empty()) std::printf("add next: %s\n", joint.advice.front().text.c_str());
}

int finish(const CalibrationRun& run, const WrittenFiles& written) {
  if (run.calibration) print_figures(run);
  std::printf("report: %s, %s\n", written.report.c_str(), written.page.c_str());
  switch (run.verdict) {
    case CalibrationVerdict::kPassed:
      std::printf("written: %s, %s\n", written.scanner.c_str(), written.camera_info.c_str());
      if (!written.kept_scanner.empty())
        std::printf("the old model is kept: %s\n", written.kept_scanner.c_str());
      return kPassed;
    case CalibrationVerdict::kLimitsMissed:
      for (const JudgedFigure& figure : run.judged) {
        if (!figure.passed()) {
          std::fprintf(stderr, "calibrate: %s: %.3f; the limit is %.3f\n", figure.name.c_str(),
                       figure.value, figure.limit);
        }
      }
      return kRefused;
    case CalibrationVerdict::kRefused:
      std::fprintf(stderr, "calibrate: refused: %s\n", run.reason.c_str());
  }
  return kRefused;
}

}  // namespace

/// Calibrates a scanner from a recorded session. Exits 0 if the result is written, 2 if it is
/// refused or misses a limit (the report says why), 1 on unusable input.
int main(int argc, char** argv) {
  CLI::App app("Calibrates camera, hand-eye and laser planes from a recorded session.");
  Options options;
  add_files(app, options);
  add_parts(app, options);
  add_limits(app, options.limits);
  add_knowledge(app, options);
  return scan_cell_common::tool_main("calibrate", app, argc, argv, [&] {
    complete(options);
    cv::setNumThreads(1);  // views are read in parallel, each by one thread
    const CalibrationRun run =
        run_calibration(options.session, options.observation, options.calibration, options.limits);
    return finish(run, save_calibration(run, options.files));
  });
}
