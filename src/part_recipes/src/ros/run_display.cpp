// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_display.h"

#include <nav_msgs/Path.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_eigen/tf2_eigen.h>
#include <visualization_msgs/MarkerArray.h>

#include "scan_cell_common/clouds/cloud_files.h"
#include "scan_cell_common/clouds/fielded_cloud.h"
#include "scan_cell_common/ros/cloud_messages.h"
#include "tool_path_stretcher/ros/conversions.h"

namespace part_recipes {
namespace {

namespace fs = std::filesystem;

/// The object with its deviations, else without; empty where there is neither.
sensor_msgs::PointCloud2 object_of(const fs::path& run, const std_msgs::Header& header) {
  for (const char* name : {"deviation.ply", "object.ply"}) {
    if (!fs::exists(run / name)) continue;
    scan_cell_common::FieldedCloud cloud;
    scan_cell_common::load_cloud_file((run / name).string(), {}, cloud);
    return to_message(std::move(cloud), header);
  }
  return scan_cell_common::to_message(scan_cell_common::Cloud(), header);
}

/// The raw scan, thinned for the eye; empty where the run has none.
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

using visualization_msgs::Marker;

/// Without points it takes the marker of that name away.
/// @param size [m]
Marker marker_of(const std::string& name, int type, const tool_paths::Points& points, double size,
                 const std_msgs::Header& header) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = points.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color.a = 1;
  for (const Eigen::Vector3d& point : points)
    marker.points.push_back(tf2::toMsg(point));
  return marker;
}

Marker spheres(const tool_paths::Points& positions, const std_msgs::Header& header) {
  constexpr double kDiameter =
      0.004;  // [m] seen beside a path, and not over its neighbours; chosen
  Marker marker = marker_of("concerned", Marker::SPHERE_LIST, positions, kDiameter, header);
  marker.color.r = 1;
  return marker;
}

/// Told apart by shape, not by colour alone: cubes are in a shadow, with a line to what makes it;
/// balls are at too grazing an angle; large cubes are out of range.
visualization_msgs::MarkerArray markers_of(const std::vector<UnseenWaypoint>& unseen,
                                           const std_msgs::Header& header) {
  constexpr double kSmall = 0.003, kLarge = 0.006, kLine = 0.0005;  // [m] chosen
  tool_paths::Points shadowed, grazing, outside, lines;
  for (const UnseenWaypoint& each : unseen) {
    (each.sight == "shadowed"  ? shadowed
     : each.sight == "grazing" ? grazing
                               : outside)
        .push_back(each.position);
    if (each.obstacle) lines.insert(lines.end(), {each.position, *each.obstacle});
  }
  visualization_msgs::MarkerArray all;
  all.markers = {marker_of("shadowed", Marker::CUBE_LIST, shadowed, kSmall, header),
                 marker_of("obstacles", Marker::LINE_LIST, lines, kLine, header),
                 marker_of("grazing", Marker::SPHERE_LIST, grazing, kSmall, header),
                 marker_of("out_of_range", Marker::CUBE_LIST, outside, kLarge, header)};
  for (Marker& marker : all.markers)
    marker.color.r = marker.color.g = marker.color.b = 0.1F;
  all.markers[2].color.r = 0.9F;
  all.markers[2].color.g = 0.6F;
  return all;
}

}  // namespace

RunDisplay::RunDisplay(ros::NodeHandle node)
    : raw_(node.advertise<sensor_msgs::PointCloud2>("raw", 1, true)),
      deviation_(node.advertise<sensor_msgs::PointCloud2>("deviation", 1, true)),
      path_(node.advertise<nav_msgs::Path>("path", 1, true)),
      adapted_(node.advertise<nav_msgs::Path>("adapted_path", 1, true)),
      concerned_(node.advertise<Marker>("concerned", 1, true)),
      unseen_(node.advertise<visualization_msgs::MarkerArray>("unseen", 1, true)) {}

void RunDisplay::show(const fs::path& run, const RunView& view) {
  if (run == shown_) return;
  std_msgs::Header header;
  header.frame_id = view.frame;
  header.stamp = ros::Time::now();
  raw_.publish(scan_of(run, header));
  deviation_.publish(object_of(run, header));
  path_.publish(tool_path_stretcher::to_path_message(view.path, header));
  adapted_.publish(tool_path_stretcher::to_path_message(view.adapted, header));
  concerned_.publish(spheres(view.positions, header));
  unseen_.publish(markers_of(view.unseen, header));
  shown_ = run;
}

}  // namespace part_recipes
