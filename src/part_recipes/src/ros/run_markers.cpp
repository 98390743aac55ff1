// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "run_markers.h"

#include <fmt/format.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>

#include "markers.h"
#include "scan_cell_common/colours/colour_scale.h"
#include "scan_cell_common/pose/units.h"

namespace part_recipes {
namespace {

using scan_cell_common::Rgb;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

constexpr Rgb kDark = {0.1F, 0.1F, 0.1F};
constexpr Rgb kOrange = {0.9F, 0.6F, 0.1F};
constexpr Rgb kRed = {1, 0, 0};
constexpr Rgb kBlue = {0, 0, 1};

/// @param height [m] of its capitals
Marker text_at(const std::string& name, std::size_t id, const Eigen::Vector3d& place,
               const std::string& text, double height, const std_msgs::Header& header) {
  Marker marker = marker_of(name, Marker::TEXT_VIEW_FACING, {place}, height, kDark, header);
  marker.id = static_cast<int>(id);
  marker.points.clear();
  marker.pose.position = tf2::toMsg(place);
  marker.text = text;
  return marker;
}

/// Removes all markers of one name, of which there may have been more before.
Marker none_of(const std::string& name, const std_msgs::Header& header) {
  Marker marker = marker_of(name, Marker::CUBE, {}, 1, kDark, header);
  marker.action = Marker::DELETEALL;
  return marker;
}

/// The text in lines of about this many letters.
std::string in_lines(const std::string& text) {
  constexpr std::size_t kWide = 60;  // letters; chosen
  std::string result;
  std::size_t begin = 0;
  for (const char letter : text) {
    const bool full = result.size() - begin > kWide && letter == ' ';
    result += full ? '\n' : letter;
    if (full) begin = result.size();
  }
  return result;
}

/// A column of colours beside the object, with figures at its ends and middle.
void add_scale(double tolerance, const Eigen::AlignedBox3d& object, double height,
               const std_msgs::Header& header, MarkerArray& all) {
  constexpr int kHalf = 4;  // steps to each end; chosen
  const Eigen::Vector3d foot(object.max().x() + 3 * height, object.center().y(), object.min().z());
  Marker column = marker_of("scale", Marker::CUBE_LIST, {}, height, kDark, header);
  column.action = Marker::ADD;
  for (int i = -kHalf; i <= kHalf; ++i) {
    const double share = static_cast<double>(i) / kHalf;
    const Eigen::Vector3d place = foot + (i + kHalf) * height * Eigen::Vector3d::UnitZ();
    column.points.push_back(tf2::toMsg(place));
    column.colors.push_back(colour_of(scan_cell_common::diverging(share)));
    if (i % (kHalf / 2) != 0) continue;
    const double figure = share * kColourSpan * tolerance * scan_cell_common::kMillimetres;
    all.markers.push_back(text_at("figures", static_cast<std::size_t>(i + kHalf),
                                  place + 4 * height * Eigen::Vector3d::UnitX(),
                                  fmt::format("{:+.3g} mm", figure), height, header));
  }
  all.markers.push_back(column);
}

}  // namespace

Marker concerned_marker(const RunView& view, const std_msgs::Header& header) {
  constexpr double kDiameter =
      0.004;  // [m] seen beside a path, and not over its neighbours; chosen
  return marker_of("concerned", Marker::SPHERE_LIST, view.positions, kDiameter, kRed, header);
}

MarkerArray unseen_markers(const RunView& view, const std_msgs::Header& header) {
  constexpr double kSmall = 0.003, kLarge = 0.006, kLine = 0.0005;  // [m] chosen
  tool_paths::Points shadowed, grazing, outside, lines;
  for (const UnseenWaypoint& each : view.unseen) {
    (each.sight == "shadowed"  ? shadowed
     : each.sight == "grazing" ? grazing
                               : outside)
        .push_back(each.position);
    if (each.obstacle) lines.insert(lines.end(), {each.position, *each.obstacle});
  }
  MarkerArray all;
  all.markers = {marker_of("shadowed", Marker::CUBE_LIST, shadowed, kSmall, kDark, header),
                 marker_of("obstacles", Marker::LINE_LIST, lines, kLine, kDark, header),
                 marker_of("grazing", Marker::SPHERE_LIST, grazing, kSmall, kOrange, header),
                 marker_of("out_of_range", Marker::CUBE_LIST, outside, kLarge, kDark, header)};
  return all;
}

MarkerArray expected_markers(const RunView& view, const std_msgs::Header& header) {
  constexpr double kBall = 0.0025, kLine = 0.0004, kAxis = 0.008;  // [m] chosen
  constexpr double kSide = 0.5;  // of the axis along the tool: the one across it; chosen
  tool_paths::Points places, along, across;
  for (const tool_paths::Segment& segment : view.adapted.segments) {
    for (const tool_paths::Waypoint& waypoint : segment.waypoints) {
      const Eigen::Vector3d at = waypoint.pose.translation();
      places.push_back(at);
      if (!view.adapted.has_orientation) continue;
      along.insert(along.end(), {at, at + kAxis * waypoint.pose.linear().col(2)});
      across.insert(across.end(), {at, at + kSide * kAxis * waypoint.pose.linear().col(0)});
    }
  }
  Marker balls = marker_of("expected", Marker::SPHERE_LIST, places, kBall, kDark, header);
  for (std::size_t i = 0; i < places.size() && places.size() == view.expected.size(); ++i)
    balls.colors.push_back(
        colour_of(scan_cell_common::brightening(view.expected[i] / view.tolerance)));
  MarkerArray all;
  all.markers = {balls, marker_of("tool_z", Marker::LINE_LIST, along, kLine, kBlue, header),
                 marker_of("tool_x", Marker::LINE_LIST, across, kLine, kRed, header)};
  return all;
}

MarkerArray sign_markers(const RunView& view, const std::vector<DeviationMark>& marks,
                         const Eigen::AlignedBox3d& object, const std_msgs::Header& header) {
  constexpr double kLetters = 0.04, kAbove = 0.3;  // of the object's diagonal; chosen
  MarkerArray all;
  all.markers = {none_of("verdict", header)};
  if (object.isEmpty()) return all;
  const double height = kLetters * object.diagonal().norm();
  const Eigen::Vector3d above(object.center().x(), object.center().y(),
                              object.max().z() + kAbove * object.diagonal().norm());
  all.markers.push_back(text_at("verdict", 0, above, in_lines(view.verdict), height, header));
  if (view.tolerance > 0) add_scale(view.tolerance, object, height, header, all);
  for (std::size_t i = 0; i < marks.size(); ++i)
    all.markers.push_back(
        text_at("signs", i, marks[i].position, marks[i].is_more ? "+" : "-", height, header));
  return all;
}

}  // namespace part_recipes
