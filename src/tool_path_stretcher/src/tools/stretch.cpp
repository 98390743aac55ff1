// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "scan_cell_common/errors.h"
#include "tool_path_stretcher/report.h"
#include "tool_path_stretcher/tool_path_files.h"

namespace {

namespace fs = std::filesystem;
using scan_cell_common::FileError;
using tool_path_stretcher::StretchParameters;
using tool_path_stretcher::StretchResult;

constexpr int kAccepted = 0;
constexpr int kUnusable = 1;
constexpr int kRefused = 2;

struct Options {
  std::string reference;
  std::string object;
  std::string path;
  std::string output;
  std::string report;
  std::string method = "general";
  std::string stand_off = "keep";
  std::vector<double> leaf;
  std::vector<double> initial_pose;
  tool_path_stretcher::PosePrior about;
  StretchParameters parameters;
};

void add_options(CLI::App& app, Options& options) {
  StretchParameters& p = options.parameters;
  options.leaf = {p.leaf.x(), p.leaf.y(), p.leaf.z()};
  app.add_option("--reference", options.reference, "reference part: PLY, PCD, STL or OBJ [m]")
      ->required();
  app.add_option("--object", options.object, "scanned object: PLY or PCD [m]")->required();
  app.add_option("--path", options.path, "tool path on the reference: CSV or YAML")->required();
  app.add_option("--output", options.output, "tool path on the object: CSV or YAML")->required();
  app.add_option("--report", options.report, "report: JSON")->required();
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

bool is_same_file(const std::string& one, const std::string& other) {
  std::error_code failure;
  if (fs::equivalent(one, other, failure)) return true;
  const fs::path place = fs::weakly_canonical(one, failure);  // also where there is none yet
  return !failure && place == fs::weakly_canonical(other, failure);
}

/// What is written must not take the place of what is read.
void refuse_overwriting(const std::string& written, const std::vector<std::string>& others) {
  for (const std::string& other : others) {
    if (!is_same_file(written, other)) continue;
    throw FileError(written, "given twice", "write to a file of its own");
  }
}

void remove_old(const std::string& path) {
  std::error_code failure;
  if (fs::exists(path, failure) && !fs::is_regular_file(path, failure)) {
    throw FileError(path, "is no file", "give a file of its own");
  }
  fs::remove(path, failure);
  if (failure) throw FileError(path, failure.message(), "give a file of yours");
}

StretchResult run(Options& options) {
  tool_path_stretcher::check_tool_path_name(options.output);
  refuse_overwriting(options.output, {options.reference, options.object, options.path});
  remove_old(options.output);  // a path of an earlier run must not be taken for this one's
  options.parameters.method = tool_path_stretcher::method_from_string(options.method);
  options.parameters.leaf = Eigen::Vector3d(options.leaf[0], options.leaf[1], options.leaf[2]);
  options.parameters.stand_off = tool_path_stretcher::stand_off_from_string(options.stand_off);
  if (!options.initial_pose.empty()) {
    options.about.pose = tool_path_stretcher::pose_from_numbers(options.initial_pose);
    options.parameters.prior.pose = options.about;
  }
  tool_path_stretcher::check(options.parameters);
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const auto path = tool_path_stretcher::load_tool_path(options.path);
  const auto reference =
      tool_path_stretcher::load_surface(options.reference, options.parameters.leaf);
  const auto object = tool_path_stretcher::load_surface(options.object, options.parameters.leaf);
  return tool_path_stretcher::stretch(
      reference, object, path, options.parameters,
      terminal ? tool_path_stretcher::Progress(show_progress) : nullptr);
}

StretchResult unusable(const std::string& message) {
  StretchResult result;
  result.verdict = {tool_path_stretcher::Reason::kUnusableInput, message, {}};
  return result;
}

/// The path before the report: an accepting report without its path would be a lie.
void save(const Options& options, StretchResult& result) {
  if (result.verdict.accepted()) {
    try {
      tool_path_stretcher::save_tool_path(options.output, result.path);
    } catch (const FileError& error) {
      result = unusable(error.what());
    }
  }
  try {
    tool_path_stretcher::save_report(options.report, result);
  } catch (const FileError&) {
    if (result.verdict.accepted()) remove_old(options.output);
    throw;
  }
}

int tell(const StretchResult& result) {
  if (result.verdict.accepted()) {
    std::cout << "accepted: scale " << result.similarity.scale << ", rms " << 1e3 * result.rms
              << " mm, " << waypoint_count(result.path) << " waypoints, " << result.seconds
              << " s\n";
    return kAccepted;
  }
  std::cerr << "refused (" << to_string(result.verdict.reason) << "): " << result.verdict.message
            << '\n';
  const bool unusable_input = result.verdict.reason == tool_path_stretcher::Reason::kUnusableInput;
  return unusable_input ? kUnusable : kRefused;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Adapts a tool path proven on a reference part to a scanned object.\n"
      "Exit code 0: accepted; 2: refused, the report says why; 1: unusable input.");
  Options options;
  add_options(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kAccepted : kUnusable;
  }
  try {
    refuse_overwriting(options.report,
                       {options.reference, options.object, options.path, options.output});
    remove_old(options.report);
    StretchResult result;
    try {
      result = run(options);
    } catch (const scan_cell_common::Error& error) {
      result = unusable(error.what());
    }
    save(options, result);
    return tell(result);
  } catch (const std::exception& error) {
    std::cerr << "stretch: " << error.what() << '\n';
    return kUnusable;
  }
}
