// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "light_sheets.h"

#include <algorithm>

namespace scan_calibration {

using scan_cell_msgs::TriggerEvent;
using scan_cell_msgs::TriggerState;
using visualization_msgs::Marker;

namespace {

constexpr double kRefresh = 0.2;   // [s] chosen
constexpr double kLifetime = 1.0;  // [s] a sheet outlives this node by; chosen

double now() {
  return ros::SteadyTime::now().toSec();
}

Marker sheet_marker(const scan_cell_common::LaserPlane& laser, const std::string& name,
                    const SheetSize& size) {
  Marker marker;
  marker.header.frame_id = name;
  marker.ns = name;
  marker.type = Marker::TRIANGLE_LIST;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color.r = 1;
  marker.color.a = 0.3F;                                   // lets what is behind it show; chosen
  marker.frame_locked = static_cast<unsigned char>(true);  // it goes with the flange
  marker.lifetime = ros::Duration(kLifetime);
  for (const Eigen::Vector3d& corner : light_sheet(laser, name, size)) {
    geometry_msgs::Point point;
    point.x = corner.x();
    point.y = corner.y();
    point.z = corner.z();
    marker.points.push_back(point);
    marker.colors.push_back(marker.color);  // with colours of its corners rviz does not shade it
  }
  return marker;
}

}  // namespace

LightSheets::LightSheets(const scan_cell_common::ScannerModel& scanner, const SheetSize& size) {
  constexpr std::uint32_t kPulses = 1000;  // a second of them; chosen
  ros::NodeHandle node;
  ros::NodeHandle own("~");
  const std::size_t lasers = std::min(scanner.lasers.size(), BurningLasers::kLasers);
  for (std::size_t i = 0; i < lasers; ++i) {
    if (!scanner.has_laser(i)) continue;
    const std::string name = scan_cell_common::laser_name(i);
    sheets_.push_back({i, sheet_marker(scanner.laser(i), name, size), false});
  }
  markers_ = own.advertise<visualization_msgs::MarkerArray>("light_sheets", 1, true);
  const boost::function<void(const TriggerState&)> on_state = [this](const TriggerState& state) {
    burning_.on_state(state.armed != 0, state.lasers, state.rate, now());
    publish_changes();
  };
  const boost::function<void(const TriggerEvent&)> on_pulse = [this](const TriggerEvent& pulse) {
    burning_.on_pulse(pulse.lasers, now());
    publish_changes();
  };
  states_ = node.subscribe<TriggerState>("trigger_state", 1, on_state);
  pulses_ = node.subscribe<TriggerEvent>("trigger_events", kPulses, on_pulse);
  refresh_ = own.createWallTimer(ros::WallDuration(kRefresh), [this](const ros::WallTimerEvent&) {
    const auto burns = [](const Sheet& sheet) { return sheet.burns; };
    if (std::any_of(sheets_.begin(), sheets_.end(), burns)) publish();
  });
  publish();
}

void LightSheets::publish() {
  visualization_msgs::MarkerArray array;
  const double at = now();
  for (Sheet& sheet : sheets_) {
    sheet.burns = burning_.burns(sheet.laser, at);
    sheet.marker.action = sheet.burns ? Marker::ADD : Marker::DELETE;
    array.markers.push_back(sheet.marker);
  }
  markers_.publish(array);
}

void LightSheets::publish_changes() {
  const double at = now();
  const auto changed = [&](const Sheet& sheet) {
    return sheet.burns != burning_.burns(sheet.laser, at);
  };
  if (std::any_of(sheets_.begin(), sheets_.end(), changed)) publish();
}

}  // namespace scan_calibration
