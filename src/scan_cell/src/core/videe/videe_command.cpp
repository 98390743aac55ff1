// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell/videe_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string_view>

#include "scan_cell_common/errors/errors.h"
#include "scan_cell_common/errors/text.h"
#include "scan_cell_common/pose/euler_angles.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell {
namespace {

using scan_cell_common::excerpt;
using scan_cell_common::ProtocolError;

using scan_cell_common::kDegrees;
using scan_cell_common::kMillimetres;

const std::map<std::string, VideeCommandKind>& kinds() {
  static const std::map<std::string, VideeCommandKind> kinds = {
      {"INIT_CYCLE", VideeCommandKind::kInitCycle},
      {"INIT_CALIBRATION", VideeCommandKind::kInitCalibration},
      {"PERFORM_CALIBRATION", VideeCommandKind::kPerformCalibration},
      {"GRAB_IMAGE", VideeCommandKind::kGrabImage},
      {"SET_POSITION", VideeCommandKind::kSetPosition},
      {"START_SCAN", VideeCommandKind::kStartScan},
      {"STOP_SCAN", VideeCommandKind::kStopScan},
      {"WAIT_SCAN", VideeCommandKind::kWaitScan},
      {"RESET", VideeCommandKind::kReset}};
  return kinds;
}

const scan_cell_common::EulerSequence& roll_pitch_yaw() {
  static const scan_cell_common::EulerSequence sequence("zyx");
  return sequence;
}

/// Six numbers separated by commas.
std::array<double, 6> six_numbers(std::string_view text) {
  constexpr double kMost = 1e6;  // a kilometre, or some thousand turns; more is invalid
  constexpr const char* kCure = "send x,y,z,rx,ry,rz in millimetres and degrees";
  std::array<double, 6> result{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const bool last = i + 1 == result.size();
    const std::size_t comma = last ? rest.size() : rest.find(',');
    if (comma == std::string_view::npos) {
      throw ProtocolError("pose '" + excerpt(text) + "'", fmt::format("{} numbers", i + 1), kCure);
    }
    const std::string_view field = rest.substr(0, comma);
    const auto value = scan_cell_common::parse_number(field);
    if (!value || !(std::abs(*value) <= kMost)) {
      throw ProtocolError("pose '" + excerpt(text) + "'",
                          "'" + excerpt(field) + "' is not a number within 1000000", kCure);
    }
    result[i] = *value;
    rest.remove_prefix(last ? comma : comma + 1);
  }
  return result;
}

}  // namespace

VideeCommand parse_videe(const std::string& line) {
  std::istringstream words(line);
  std::string name;
  words >> name;
  const auto kind = kinds().find(name);
  if (kind == kinds().end()) {
    throw ProtocolError("command '" + excerpt(name) + "'", "unknown",
                        "send one of the ViDeE commands in capital letters");
  }
  VideeCommand command;
  command.kind = kind->second;
  std::string argument;
  while (words >> argument)
    command.poses.push_back(pose_from_wire(argument));
  const bool positions = command.kind == VideeCommandKind::kSetPosition;
  const std::size_t count = command.poses.size();
  if (positions ? count == 0 || count % 2 != 0 : count != 0) {
    throw ProtocolError(name, fmt::format("{} arguments", count),
                        positions ? "send start and end of each pass" : "send 0");
  }
  return command;
}

Eigen::Isometry3d pose_from_wire(const std::string& text) {
  const std::array<double, 6> values = six_numbers(text);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() << values[0] / kMillimetres, values[1] / kMillimetres,
      values[2] / kMillimetres;
  pose.linear() =
      roll_pitch_yaw().rotation(Eigen::Vector3d(values[5], values[4], values[3]) / kDegrees);
  return pose;
}

std::string pose_to_wire(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d zyx = roll_pitch_yaw().angles(pose.linear()) * kDegrees;
  const Eigen::Vector3d p = pose.translation() * kMillimetres;
  char text[160];
  std::snprintf(text, sizeof(text), "%.4f,%.4f,%.4f,%.6f,%.6f,%.6f", p.x(), p.y(), p.z(), zyx[2],
                zyx[1], zyx[0]);
  return text;
}

}  // namespace scan_cell
