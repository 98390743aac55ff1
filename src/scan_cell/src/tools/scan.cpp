// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <ros/ros.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <optional>

#include "client/bag_recording.h"
#include "client/clean_cloud_watch.h"
#include "client/scan_record.h"
#include "scan_cell/progress_bar.h"
#include "scan_cell/ros/cell_client.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/pose/units.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "scan_cell_common/ros/node_main.h"

namespace {

struct Options {
  std::string program;
  std::string scan_id;
  std::string output;
  std::string clean;
  std::string report;
  std::string bag;
  std::map<std::string, std::string> calibrated_with;  // SHA-256 of its files, by name
  std::string units = "m";
  double timeout = 10;
};

void save(const std::string& path, const sensor_msgs::PointCloud2& message,
          const std::string& units) {
  const scan_cell_common::CloudView cloud = scan_cell_common::view_of(message);
  scan_cell_common::save_cloud(path, cloud, scan_cell_common::metres_per(units));
  std::printf("%s: %zu points\n", path.c_str(), cloud.size());
}

/// Prints how the scan ended and saves what it captured.
void tell(const Options& options, const scan_cell_msgs::ScanResult& result) {
  std::printf("scan '%s': %lu pulses, %lu frames, %lu bound, %lu dropped, %lu never arrived\n",
              result.scan_id.c_str(), result.audit.triggers, result.audit.frames,
              result.audit.frames_bound, result.audit.frames_dropped,
              result.audit.frames_never_arrived);
  for (const std::string& warning : result.warnings)
    std::printf("warning: %s\n", warning.c_str());
  if (!result.statistics.agreement_message.empty())
    std::printf("passes: %s\n", result.statistics.agreement_message.c_str());
  if (!result.cloud_file.empty()) {
    std::printf("%s: %lu points, too many for a message\n", result.cloud_file.c_str(),
                result.statistics.points);
  }
  if (!options.output.empty() && !result.cloud.data.empty()) {
    save(options.output, result.cloud, options.units);
  }
  if (result.outcome != scan_cell_msgs::ScanResult::FINISHED) {
    throw scan_cell_common::Refused("scan '" + result.scan_id + "'", "ended early", result.message);
  }
  std::printf("%s\n", result.message.c_str());
}

/// @throw Refused before anything moves if the cell does not have the required calibration; the
/// report then gives the one it has
void check_calibration(const Options& options, const scan_cell::CalibrationFiles& files) {
  const scan_cell::Json now = to_json(files);
  for (const auto& [name, hash] : options.calibrated_with) {
    if (!now.contains(name))
      throw scan_cell_common::InvalidParameter("--calibrated-with", name, "give scanner or cell");
    if (now[name]["sha256"].is_null() || now[name]["sha256"] == hash) continue;
    const auto file = now[name]["name"].get<std::string>();
    const std::string message = "is not the one that was asked for (--calibrated-with)";
    if (!options.report.empty())
      scan_cell::save_json(options.report,
                           {{"message", file + " " + message}, {"calibration", now}});
    throw scan_cell_common::Refused(
        fmt::format("the cell's {} file {}", name, file), message,
        "start the cell with the other file, or check that this one is right and ask for it");
  }
}

/// @throw Refused if the scan did not finish, or preprocessing failed
void scan(const Options& options) {
  for (const std::string& output : {options.output, options.clean}) {
    if (!output.empty()) scan_cell_common::check_cloud_output(output);
  }
  const scan_cell::ScanProgram program = scan_cell::load_scan_program(options.program);
  const scan_cell::CellClient::Names names;
  ros::NodeHandle node;
  scan_cell::CellClient client(node, names);
  check_calibration(options, client.calibration_files());
  const std::optional<scan_cell::CameraRegion> region = client.camera_region();
  std::optional<scan_cell::CleanCloudWatch> watch;
  if (!options.clean.empty()) watch.emplace(node, names.clean_cloud, names.report);
  std::optional<scan_cell::BagRecording> recording;
  if (!options.bag.empty()) recording.emplace(node, options.bag, options.timeout);
  scan_cell_msgs::ScanResult result;
  {
    scan_cell::ProgressBar bar("scan");
    result = client.scan(program, options.scan_id, options.timeout,
                         [&bar](const std::string& what, double share) { bar.show(what, share); });
  }
  if (recording) recording->finish(result.scan_id);
  if (!options.report.empty())
    scan_cell::save_scan_record(options.report, result, client.calibration_files(), region);
  tell(options, result);
  if (!watch) return;
  scan_cell::check_published(result.cloud_file);
  constexpr double kCleaningTimeout = 60;  // [s] chosen
  save(options.clean, watch->wait(result.cloud.header.stamp, kCleaningTimeout), options.units);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  scan_cell_common::Outputs outputs;
  CLI::App app("Scans a program with the running cell and saves the cloud");
  app.add_option("--program", options.program, "scan program (YAML)")->required();
  app.add_option("--id", options.scan_id, "name of the scan; made from the time if not given");
  outputs.add(app, "--output", options.output, "whole cloud as it was scanned (.ply, .pcd)");
  outputs.add(app, "--report", options.report,
              "how its frames were bound, how its passes agree, what the cell is calibrated with "
              "(.json)");
  outputs.add(app, "--bag", options.bag, "what replay needs to make the cloud again (.bag)");
  outputs.add(app, "--clean", options.clean, "clean cloud of one object (.ply, .pcd)");
  app.add_option(
      "--calibrated-with", options.calibrated_with,
      "NAME SHA256 of the cell's scanner and cell files: with other files it does not scan");
  app.add_option("--units", options.units, "of the clouds")
      ->check(CLI::IsMember(scan_cell_common::length_units()))
      ->capture_default_str();
  app.add_option("--timeout", options.timeout, "seconds to wait for the cell");
  return scan_cell_common::ros_tool_main(
      "scan", app, argc, argv,
      [&] {
        scan(options);
        return 0;
      },
      scan_cell_common::kRefused, outputs);
}
