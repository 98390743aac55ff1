// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_display.h"

#include <nav_msgs/Path.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "run_markers.h"
#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "tool_path_stretcher/ros/conversions.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

using scan_cell_common::FieldedCloud;

/// The object, with its deviations if known; empty if the run has no object.
FieldedCloud object_of(const fs::path& run) {
  FieldedCloud cloud;
  for (const char* name : {"deviation.ply", "object.ply"}) {
    if (!fs::exists(run / name)) continue;
    scan_cell_common::load_cloud_file((run / name).string(), {}, cloud);
    break;
  }
  return cloud;
}

/// The raw scan, thinned for display; empty if the run has none.
sensor_msgs::PointCloud2 scan_of(const fs::path& run, const std_msgs::Header& header) {
  constexpr std::size_t kMostShown = 2'000'000;  // points; 24 MB, and a second of an old computer
  scan_cell_common::Cloud shown;
  const fs::path file = run / "inputs" / "scan.ply";
  if (fs::exists(file)) {
    const scan_cell_common::Cloud scan = scan_cell_common::load_cloud(file.string());
    const std::size_t step = 1 + scan.size() / (kMostShown + 1);
    for (std::size_t i = 0; i < scan.size(); i += step)
      shown.push_back(scan[i]);
  }
  return scan_cell_common::to_message(shown, header);
}

}  // namespace

RunDisplay::RunDisplay(ros::NodeHandle node)
    : raw_(node.advertise<sensor_msgs::PointCloud2>("raw", 1, true)),
      deviation_(node.advertise<sensor_msgs::PointCloud2>("deviation", 1, true)),
      path_(node.advertise<nav_msgs::Path>("path", 1, true)),
      adapted_(node.advertise<nav_msgs::Path>("adapted_path", 1, true)),
      concerned_(node.advertise<visualization_msgs::Marker>("concerned", 1, true)),
      unseen_(node.advertise<visualization_msgs::MarkerArray>("unseen", 1, true)),
      expected_(node.advertise<visualization_msgs::MarkerArray>("expected", 1, true)),
      signs_(node.advertise<visualization_msgs::MarkerArray>("signs", 1, true)) {}

void RunDisplay::show(const fs::path& run, const RunView& view) {
  if (run == shown_) return;
  std_msgs::Header header;
  header.frame_id = view.frame;
  header.stamp = ros::Time::now();
  raw_.publish(scan_of(run, header));
  const FieldedCloud object = object_of(run);
  deviation_.publish(object.size() == 0
                         ? scan_cell_common::to_message(scan_cell_common::Cloud(), header)
                         : to_message(coloured(object, view.tolerance), header));
  path_.publish(tool_path_stretcher::to_path_message(view.path, header));
  adapted_.publish(tool_path_stretcher::to_path_message(view.adapted, header));
  concerned_.publish(concerned_marker(view, header));
  unseen_.publish(unseen_markers(view, header));
  expected_.publish(expected_markers(view, header));
  signs_.publish(
      sign_markers(view, deviation_marks(object, view.tolerance), box_of(object), header));
  shown_ = run;
}

}  // namespace part_recipes
