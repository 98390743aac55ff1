// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>

#include "file_options.h"
#include "scan_cell_common/errors.h"
#include "scan_cell_common/files.h"
#include "scan_cell_common/tool_main.h"
#include "scan_cell_common/units.h"
#include "tool_path_stretcher/report.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace {

using scan_cell_common::FileError;
using scan_cell_common::kRefused;
using scan_cell_common::kUnusable;
using scan_cell_common::Outputs;
using scan_cell_common::refuse_overwriting;
using scan_cell_common::remove_old;
using tool_path_stretcher::StretchParameters;
using tool_path_stretcher::StretchResult;

constexpr int kAccepted = 0;

struct Options {
  std::string reference;
  std::string object;
  std::string path;
  std::string output;
  std::string report;
  std::string method = "general";
  std::string stand_off = "keep";
  tool_path_stretcher::FileOptions files;
  std::vector<double> leaf;
  std::vector<double> initial_pose;
  tool_path_stretcher::PosePrior about;
  StretchParameters parameters;
};

void add_options(CLI::App& app, Options& options, Outputs& outputs) {
  StretchParameters& p = options.parameters;
  options.leaf = {p.leaf.x(), p.leaf.y(), p.leaf.z()};
  app.add_option("--reference", options.reference,
                 "reference part: a cloud (PLY, PCD, XYZ, CSV) or a mesh (STL, OBJ, PLY)")
      ->required();
  app.add_option("--object", options.object, "scanned object: PLY, PCD, XYZ or CSV")->required();
  app.add_option("--path", options.path, "tool path on the reference: CSV or YAML")->required();
  outputs.add(app, "--output", options.output, "tool path on the object: CSV or YAML")->required();
  outputs.add(app, "--report", options.report, "report: JSON")->required();
  add_file_options(app, options.files);
  app.add_option("--method", options.method, "affine or general")->capture_default_str();
  app.add_option("--leaf", options.leaf, "grid reduction x y z [m]")
      ->capture_default_str()
      ->expected(3);
  app.add_option("--scale", p.prior.scale.value, "known before; 0: free")->capture_default_str();
  app.add_option("--scale-deviation", p.prior.scale.deviation,
                 "of the scale known before, one standard deviation; 0: it is exact")
      ->capture_default_str();
  app.add_option("--initial-pose", options.initial_pose,
                 "reference to object, known before: x y z [m] qx qy qz qw")
      ->expected(7);
  app.add_option("--initial-pose-angle", options.about.angle, "farthest that may be off [rad]")
      ->capture_default_str();
  app.add_option("--initial-pose-distance", options.about.distance,
                 "farthest that may put the reference's centroid off [m]")
      ->capture_default_str();
  app.add_option("--resample-spacing", p.resample_spacing,
                 "steps of the path [m]; 0: its own waypoints")
      ->capture_default_str();
  app.add_option("--stand-off", options.stand_off,
                 "keep: of a path that does not touch, as long as it is; scale: with the part")
      ->capture_default_str();
  app.add_option("--min-scale", p.min_scale, "least scale accepted")->capture_default_str();
  app.add_option("--max-scale", p.max_scale, "greatest scale accepted")->capture_default_str();
  app.add_option("--scale-range", p.scale_range, "affine: range searched, 0.15 = +-15 %")
      ->capture_default_str();
  app.add_option("--scale-steps", p.scale_steps, "affine: steps to each side")
      ->capture_default_str();
  app.add_option("--min-points", p.min_points, "least points of a cloud")->capture_default_str();
  app.add_option("--max-path-distance", p.max_path_distance,
                 "farthest a waypoint may be from the reference [m]")
      ->capture_default_str();
  app.add_option("--inlier-distance", p.inlier_distance, "of an explained point [m]")
      ->capture_default_str();
  app.add_option("--min-inlier-ratio", p.min_inlier_ratio, "of the object's points")
      ->capture_default_str();
  app.add_option("--min-overlap", p.min_overlap, "share of the reference scanned")
      ->capture_default_str();
  app.add_option("--ambiguity-distance", p.ambiguity_distance,
                 "two poses differ if they put a waypoint so far apart [m]")
      ->capture_default_str();
  app.add_option("--deformation-level", p.deformation_level,
                 "finest deformation graph, 1 to 3; 0: none")
      ->capture_default_str();
  app.add_option("--support-radius", p.support_radius, "of a waypoint [m]; 0: automatic")
      ->capture_default_str();
  app.add_option("--min-support", p.min_support, "scanned points beside a waypoint")
      ->capture_default_str();
  app.add_option("--max-hole-distance", p.max_hole_distance,
                 "up to which a waypoint is inferred [m]")
      ->capture_default_str();
  app.add_option("--tolerance", p.tolerance, "waypoint to scanned surface [m]")
      ->capture_default_str();
  app.add_option("--max-deformation", p.max_deformation,
                 "of 95 % of the surface, or it is the wrong part [m]")
      ->capture_default_str();
  app.add_option("--max-stranger", p.max_stranger,
                 "of scanned points beside a waypoint from the reference [m]")
      ->capture_default_str();
  app.add_option("--max-displacement", p.max_displacement, "over the similarity [m]")
      ->capture_default_str();
}

bool show_progress(const std::string& stage, double progress) {
  std::fprintf(stderr, "\r%3d %% %-16s", static_cast<int>(100 * progress), stage.c_str());
  if (progress >= 1) std::fputc('\n', stderr);
  std::fflush(stderr);
  return true;
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// What a run has found out so far.
struct Run {
  StretchResult result;
  tool_path_stretcher::RunRecord record;
  tool_path_stretcher::PathLayout layout;
};

/// A path of an earlier run must not be taken for this one's.
void remove_old_path(const Options& options) {
  refuse_overwriting(options.output, {options.reference, options.object, options.path});
  remove_old(options.output);
}

void remove_old_report(const Options& options) {
  refuse_overwriting(options.report,
                     {options.reference, options.object, options.path, options.output});
  try {
    scan_cell_common::check_output(options.report, {".json"}, "write the report as .json");
    remove_old(options.report);
  } catch (const FileError&) {
    remove_old_path(options);
    throw;
  }
}

/// All that can be wrong with the options, before any file is read.
void check_options(Options& options) {
  tool_path_stretcher::check_tool_path_name(options.output);
  remove_old_path(options);
  options.parameters.method = tool_path_stretcher::method_from_string(options.method);
  options.parameters.leaf = Eigen::Vector3d(options.leaf[0], options.leaf[1], options.leaf[2]);
  options.parameters.stand_off = tool_path_stretcher::stand_off_from_string(options.stand_off);
  if (!options.initial_pose.empty()) {
    options.about.pose = tool_path_stretcher::pose_from_numbers(options.initial_pose);
    options.parameters.prior.pose = options.about;
  }
  tool_path_stretcher::check(options.parameters);
}

tool_path_stretcher::ToolPath read_path(const Options& options, Run& run) {
  using namespace tool_path_stretcher;
  ToolPathFile file = load_tool_path_file(options.path, options.files.path_conventions());
  run.record.path = contents_of(file.path, file.layout);
  run.record.path_file = record_of(options.path, file.layout.pose.units);
  run.layout = std::move(file.layout);
  std::cout << "path: " << to_string(*run.record.path) << std::endl;
  return std::move(file.path);
}

tool_path_stretcher::Surface read_surface(const std::string& file, const std::string& units,
                                          const Options& options,
                                          std::optional<tool_path_stretcher::FileRecord>& record) {
  const double metres = scan_cell_common::metres_per(units);
  record = tool_path_stretcher::record_of(file, units);
  return tool_path_stretcher::load_surface(file, options.parameters.leaf, metres);
}

void adapt(Options& options, Run& run) {
  const Clock::time_point start = Clock::now();
  check_options(options);
  const tool_path_stretcher::ToolPath path = read_path(options, run);
  const auto reference = read_surface(options.reference, options.files.units_of_reference(),
                                      options, run.record.reference);
  const auto object =
      read_surface(options.object, options.files.units_of_object(), options, run.record.object);
  run.record.seconds_reading = seconds_since(start);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  run.result = tool_path_stretcher::stretch(
      reference, object, path, options.parameters,
      terminal ? tool_path_stretcher::Progress(show_progress) : nullptr);
}

StretchResult unusable(const std::string& message) {
  StretchResult result;
  result.verdict = {tool_path_stretcher::Reason::kUnusableInput, message, {}};
  return result;
}

/// CSV has no place for what else stands in YAML.
void tell_what_is_left_out(const Options& options, const Run& run) {
  if (!run.layout.yaml || scan_cell_common::extension_of(options.output) != ".csv") return;
  for (const std::string& key : run.layout.kept)
    std::cout << "left out of " << options.output << ": " << key << '\n';
}

void save_path(const Options& options, Run& run) {
  const Clock::time_point start = Clock::now();
  try {
    tool_path_stretcher::save_tool_path(options.output, run.result.path, run.layout);
    tell_what_is_left_out(options, run);
    run.record.output = tool_path_stretcher::record_of(options.output, run.layout.pose.units);
  } catch (const scan_cell_common::Error& error) {
    run.result = unusable(error.what());
  }
  run.record.seconds_writing = seconds_since(start);
}

/// The path before the report: an accepting report without its path would be a lie.
void save(const Options& options, Run& run) {
  if (run.result.verdict.accepted()) save_path(options, run);
  try {
    tool_path_stretcher::save_report(options.report, run.result, run.record);
  } catch (const FileError&) {
    if (run.result.verdict.accepted()) remove_old(options.output);
    throw;
  }
}

/// To three digits, which say enough.
std::string three_digits(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

int tell(const Run& run) {
  const StretchResult& result = run.result;
  if (result.verdict.accepted()) {
    std::cout << "accepted: " << to_string(tool_path_stretcher::summary_of(result.quality))
              << "; scale " << result.similarity.scale << ", rms " << three_digits(1e3 * result.rms)
              << " mm; " << three_digits(total_seconds(result, run.record)) << " s (reading "
              << three_digits(run.record.seconds_reading) << ", adapting "
              << three_digits(result.seconds) << ", writing "
              << three_digits(run.record.seconds_writing) << ")\n";
    return kAccepted;
  }
  std::cerr << "refused (" << to_string(result.verdict.reason) << "): " << result.verdict.message
            << '\n';
  const bool unusable_input = result.verdict.reason == tool_path_stretcher::Reason::kUnusableInput;
  return unusable_input ? kUnusable : kRefused;
}

/// @return the process's exit code
int run_and_report(Options& options) {
  remove_old_report(options);
  Run run;
  const Clock::time_point start = Clock::now();
  try {
    adapt(options, run);
  } catch (const scan_cell_common::Error& error) {
    run.record.seconds_reading = seconds_since(start);
    run.result = unusable(error.what());
  }
  save(options, run);
  return tell(run);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Adapts a tool path proven on a reference part to a scanned object.\n"
      "Exit code 0: accepted; 2: refused, the report says why; 1: unusable input.");
  Options options;
  // What is wrong with the path's name goes into the report.
  Outputs outputs(Outputs::Clearing::kByTool);
  add_options(app, options, outputs);
  return scan_cell_common::tool_main(
      "stretch", app, argc, argv, [&] { return run_and_report(options); }, kUnusable, outputs);
}
