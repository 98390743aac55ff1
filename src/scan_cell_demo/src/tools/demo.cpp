// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <scan_cell_msgs/LoadWorld.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/goals.h"
#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/adaptation_report.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell/ros/service_call.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/node_main.h"
#include "scan_cell_demo/comparison.h"
#include "tool_path_stretcher/ros/conversions.h"
#include "tool_paths/tool_path_files.h"
#include "tools/true_tip.h"

namespace {

using scan_cell_common::Cloud;
using tool_path_stretcher::ToolPath;

using scan_cell_common::kMillimetres;
constexpr const char* kAdaptedPath = "adapted_path.csv";
constexpr const char* kTruePath = "true_path.csv";
constexpr const char* kReport = "report.json";
constexpr const char* kAdaptation = "adaptation.json";
constexpr const char* kTracedPath = "traced_path.csv";
constexpr int kGoalMissed = 3;

struct Options {
  std::string output = "out";
  std::string reference = ros::package::getPath("scan_cell_sim") + "/config/reference_frame.yaml";
  std::string object = ros::package::getPath("scan_cell_sim") + "/config/object_frame.yaml";
  std::string program = ros::package::getPath("scan_cell") + "/config/both_lasers.yaml";
  std::string part = "frame";
  std::string simulator = "/scan_cell_sim";
  std::string true_cell = ros::package::getPath("scan_cell_sim") + "/config/cell.yaml";
  bool no_work = false;
  double timeout = 60;          // [s] for the cell to start
  scan_cell_demo::Goals goals;  // [m]
};

/// Result of one scan.
struct Scanned {
  Cloud clean;
  std_msgs::Header header;
  scan_cell_msgs::ScanResult result;
};

class Demo {
 public:
  explicit Demo(const Options& options)
      : options_(options), program_(scan_cell::load_scan_program(options.program)) {}

  /// @return the process's exit code
  int run() {
    const Scanned reference = scan("reference", options_.reference);
    const Scanned object = scan("object", options_.object);
    const ToolPath path = proven_path();
    const auto stretched = stretch(reference, object, path);
    if (is_accepted(stretched)) save_paths(object, path, stretched);
    if (is_accepted(stretched) && !options_.no_work) work();
    const std::vector<std::string> missed = report(reference, object, stretched);
    for (const std::string& goal : missed)
      std::fprintf(stderr, "goal missed: %s\n", goal.c_str());
    if (is_accepted(stretched)) return missed.empty() ? 0 : kGoalMissed;
    std::fprintf(stderr, "refused: %s\n", stretched.verdict.message.c_str());
    return scan_cell_common::kRefused;
  }

 private:
  std::string out(const std::string& name) const { return options_.output + "/" + name; }

  Scanned scan(const std::string& name, const std::string& world) {
    scan_cell_msgs::LoadWorld::Request request;
    request.path = world;
    wait_for_service(options_.simulator + "/load_world");
    scan_cell::call<scan_cell_msgs::LoadWorld>(options_.simulator + "/load_world", request,
                                               options_.timeout);
    Scanned scanned;
    scan_cell::ProgressBar bar("scan the " + name);
    const sensor_msgs::PointCloud2 clean = client_.scan_clean(
        program_, name, options_.timeout,
        [&bar](const std::string& what, double share) { bar.show(what, share); }, scanned.result);
    scanned.header = clean.header;
    scanned.clean = scan_cell_common::from_message(clean);
    scan_cell_common::save_cloud(out(name + ".ply"), scanned.clean);
    return scanned;
  }

  void wait_for_service(const std::string& name) const {
    if (!ros::service::waitForService(name, ros::Duration(options_.timeout))) {
      throw scan_cell_common::ConnectionError(name, "no such service",
                                              "start the cell with sim:=true");
    }
  }

  ToolPath proven_path() const {
    const ToolPath path = scan_cell_demo::proven_path(options_.reference, options_.part);
    tool_paths::save_tool_path(out("tool_path.csv"), path);
    return path;
  }

  scan_cell_msgs::StretchToolPathResult stretch(const Scanned& reference, const Scanned& object,
                                                const ToolPath& path) {
    scan_cell_msgs::StretchToolPathGoal goal;
    goal.reference = scan_cell_common::to_message(reference.clean, reference.header);
    goal.object = scan_cell_common::to_message(object.clean, object.header);
    goal.path = tool_path_stretcher::to_message(path, reference.header);
    scan_cell::ProgressBar bar("adapt the path");
    return client_.stretch(goal, options_.timeout, [&bar](const std::string& what, double share) {
      bar.show(what, share);
    });
  }

  /// Saves the adapted path as ~work takes it, and the true path.
  void save_paths(const Scanned& object, const ToolPath& path,
                  const scan_cell_msgs::StretchToolPathResult& stretched) {
    tool_paths::save_tool_path(out(kAdaptedPath),
                               tool_path_stretcher::from_message(stretched.path));
    truth_ = scan_cell_demo::true_path(path, options_.reference, options_.object, options_.part);
    tool_paths::save_tool_path(out(kTruePath), truth_);
    scan_cell_common::save_text(
        out(kAdaptation),
        scan_cell::completed(
            stretched.report,
            {out("reference.ply"), out("tool_path.csv"), "m", out("object.ply"), out(kAdaptedPath),
             object.header.stamp.toSec(), client_.calibration_files()},
            object.result.statistics));
  }

  /// Makes the robot follow the adapted path with the tool.
  void work() {
    scan_cell_msgs::WorkGoal goal;
    goal.path = std::filesystem::absolute(out(kAdaptedPath)).string();
    goal.report = std::filesystem::absolute(out(kAdaptation)).string();
    goal.waypoint_z = scan_cell_msgs::WorkGoal::Z_INTO_PART;
    scan_cell_demo::TrueTip tip(ros::NodeHandle(), options_.simulator, options_.true_cell);
    scan_cell::ProgressBar bar("trace the path");
    const auto result =
        client_.work(goal, options_.timeout,
                     [&bar](const std::string& what, double share) { bar.show(what, share); });
    if (result.outcome != scan_cell_msgs::WorkResult::FINISHED)
      throw scan_cell_common::Refused("work", "ended early", result.message);
    const std::vector<Eigen::Vector3d> way = tip.way();
    traced_ = scan_cell_demo::compare_way(way, truth_);
    save_way(way);
  }

  void save_way(const std::vector<Eigen::Vector3d>& way) const {
    std::string text = "x,y,z\n";
    for (const Eigen::Vector3d& place : way)
      text += fmt::format("{:.6f},{:.6f},{:.6f}\n", place.x(), place.y(), place.z());
    scan_cell_common::save_text(out(kTracedPath), text);
  }

  /// @return the missed goals; there are none for a refused path
  std::vector<std::string> report(const Scanned& reference, const Scanned& object,
                                  const scan_cell_msgs::StretchToolPathResult& stretched) const {
    scan_cell_demo::Figures figures;
    nlohmann::ordered_json json;
    json["verdict"] = is_accepted(stretched) ? "accepted" : "refused";
    json["reason"] = stretched.verdict.name;
    json["message"] = stretched.verdict.message;
    json["scale"] = stretched.similarity.scale;
    json["scale_true"] =
        scan_cell_demo::true_scale(options_.reference, options_.object, options_.part);
    figures.cloud_rms = add_cloud_errors(json, reference, object);
    const scan_cell_demo::PathError error = add_path_errors(json, stretched);
    figures.path_rms = error.rms;
    figures.path_max = error.max;
    if (traced_) {
      figures.worked = true;
      figures.tip_rms = traced_->rms;
      figures.tip_max = traced_->max;
      json["tip_rms_mm"] = traced_->rms * kMillimetres;
      json["tip_max_mm"] = traced_->max * kMillimetres;
    }
    for (const Scanned* scanned : {&reference, &object}) {
      figures.pulses += scanned->result.audit.triggers;
      figures.frames_bound += scanned->result.audit.frames_bound;
      figures.frames_accounted_for += scanned->result.audit.dropped.size();
    }
    add_frames(json, reference, object);
    json["scan_s"] = reference.result.seconds + object.result.seconds;
    json["stretch_s"] = stretched.seconds;
    const std::vector<std::string> missed =
        is_accepted(stretched) ? scan_cell_demo::missed_goals(figures, options_.goals)
                               : std::vector<std::string>();
    if (is_accepted(stretched)) json["goals_missed"] = missed;
    scan_cell_common::save_text(out("report.json"), json.dump(2) + "\n");
    std::printf("%s\n", json.dump(2).c_str());
    return missed;
  }

  static void add_frames(nlohmann::ordered_json& json, const Scanned& reference,
                         const Scanned& object) {
    const auto& a = reference.result.audit;
    const auto& b = object.result.audit;
    json["frames"] = a.frames + b.frames;
    json["frames_bound"] = a.frames_bound + b.frames_bound;
    json["frames_dropped"] = a.frames_dropped + b.frames_dropped;
    json["frames_never_arrived"] = a.frames_never_arrived + b.frames_never_arrived;
  }

  /// @return the greater error of the two clouds [m]: the path depends on both
  double add_cloud_errors(nlohmann::ordered_json& json, const Scanned& reference,
                          const Scanned& object) const {
    const double of_reference =
        scan_cell_demo::cloud_error(reference.clean, options_.reference).rms;
    const double of_object = scan_cell_demo::cloud_error(object.clean, options_.object).rms;
    json["cloud_rms_mm"] = std::max(of_reference, of_object) * kMillimetres;
    json["cloud_rms_reference_mm"] = of_reference * kMillimetres;
    json["cloud_rms_object_mm"] = of_object * kMillimetres;
    return std::max(of_reference, of_object);
  }

  /// @return NaN, and null in the report, if there is no path
  scan_cell_demo::PathError add_path_errors(
      nlohmann::ordered_json& json, const scan_cell_msgs::StretchToolPathResult& stretched) const {
    scan_cell_demo::PathError error;
    error.rms = error.max = error.orientation_rms = std::numeric_limits<double>::quiet_NaN();
    if (is_accepted(stretched)) {
      const ToolPath adapted = tool_path_stretcher::from_message(stretched.path);
      const bool own_image = !stretched.verdict.candidates.empty();
      error = own_image ? scan_cell_demo::compare_lines(adapted, truth_)
                        : scan_cell_demo::compare(adapted, truth_);
    }
    json["path_rms_mm"] = error.rms * kMillimetres;  // NaN is written as null
    json["path_max_mm"] = error.max * kMillimetres;
    json["path_orientation_rms_deg"] = error.orientation_rms * 180 / M_PI;
    return error;
  }

  static bool is_accepted(const scan_cell_msgs::StretchToolPathResult& stretched) {
    return stretched.verdict.reason == scan_cell_msgs::StretchVerdict::ACCEPTED;
  }

  Options options_;
  scan_cell::ScanProgram program_;
  ToolPath truth_;
  std::optional<scan_cell_demo::PathError> traced_;
  scan_cell::CellClient client_{ros::NodeHandle(), {}};
};

/// Adds a goal, in millimetres on the command line.
void add_goal(CLI::App& app, const std::string& name, double& goal, const std::string& meaning) {
  app.add_option_function<double>(
         name, [&goal](double millimetres) { goal = millimetres / kMillimetres; },
         fmt::format("goal [mm]: largest distance {}", meaning))
      ->default_str(fmt::format("{:g}", goal * kMillimetres));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  scan_cell_common::Outputs outputs;
  CLI::App app(
      "Scans two parts in the simulated cell, adapts the path, traces it with the tool, and "
      "compares "
      "both with the truth.\n"
      "Exit code 0: accepted, all goals met; 2: refused; 3: a goal missed; 1: no result.");
  outputs
      .add_folder(app, "--output", options.output, "folder for clouds, paths and report",
                  {kAdaptedPath, kTruePath, kReport, kAdaptation, kTracedPath})
      ->capture_default_str();
  app.add_option("--reference", options.reference, "world file of the reference part");
  app.add_option("--object", options.object, "world file of the changed part");
  app.add_option("--program", options.program, "scan program");
  app.add_option("--part", options.part, "name of the part in both worlds");
  add_goal(app, "--max-cloud-rms", options.goals.cloud_rms,
           "of a cloud from the true surfaces, RMS");
  add_goal(app, "--max-path-rms", options.goals.path_rms, "of the path from the true one, RMS");
  add_goal(app, "--max-path-error", options.goals.path_max, "of the path's farthest waypoint");
  app.add_flag("--no-work", options.no_work, "do not trace the adapted path with the tool");
  add_goal(app, "--max-tip-rms", options.goals.tip_rms,
           "of the tool's true tip from the true path, RMS");
  add_goal(app, "--max-tip-error", options.goals.tip_max, "of the tip at the farthest waypoint");
  app.add_option("--true-cell", options.true_cell, "the simulator's own cell file");
  app.add_option("--simulator", options.simulator, "node of the simulator");
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell");
  return scan_cell_common::ros_tool_main(
      "demo", app, argc, argv, [&] { return Demo(options).run(); }, scan_cell_common::kUnusable,
      outputs);
}
