// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "signs/signs.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <filesystem>

namespace scan_cell_rviz {

using diagnostic_msgs::DiagnosticStatus;
using scan_cell_msgs::CellState;
using scan_cell_msgs::RobotStatus;

Sign sign_of(const RobotStatus& robot) {
  if (!robot.connected) return {Level::kBad, "no link to the controller: " + robot.message};
  if (robot.e_stopped == RobotStatus::YES) return {Level::kBad, "emergency stop"};
  if (!robot.alarm_texts.empty()) return {Level::kBad, "alarm: " + robot.alarm_texts.front()};
  if (robot.drives_powered == RobotStatus::NO) return {Level::kNotice, "drives are off"};
  if (robot.motion_possible == RobotStatus::NO)
    return {Level::kNotice, "accepts no motion: mode " + robot.controller_mode};
  return {Level::kGood, robot.in_motion == RobotStatus::YES ? "moving" : "ready"};
}

Sign sign_of(const scan_cell_msgs::TriggerState& trigger) {
  if (trigger.lasers != 0) {
    std::string lines;
    for (int line = 0; line < 8; ++line)
      if ((trigger.lasers & (1 << line)) != 0) lines += fmt::format(" {}", line);
    return {Level::kLaser, "ON:" + lines};
  }
  if (trigger.armed) return {Level::kNotice, "armed"};
  return {Level::kGood, "off"};
}

Sign sign_of(const CellState& cell) {
  switch (cell.state) {
    case CellState::SCANNING:
      return {Level::kGood, "scanning " + cell.scan_id};
    case CellState::FAILED:
      return {Level::kNotice, cell.message.empty() ? "the last scan ended early" : cell.message};
    default:
      return {Level::kGood, "ready"};
  }
}

Sign sign_of(const DiagnosticStatus& camera) {
  if (camera.level == DiagnosticStatus::OK) return {Level::kGood, camera.message};
  return {camera.level == DiagnosticStatus::WARN ? Level::kNotice : Level::kBad, camera.message};
}

QString age_text(double age) {
  constexpr double kDay = 86400;
  const long days = std::lround(std::max(0.0, age) / kDay);
  return days == 1 ? QCoreApplication::translate("Signs", "1 day")
                   : QCoreApplication::translate("Signs", "%1 days").arg(days);
}

Sign calibration_sign(const std::string& file, const std::string& sha256, double age) {
  if (file.empty()) return {Level::kBad, "the cell names no scanner model"};
  const std::string name = std::filesystem::path(file).filename().string();
  if (sha256.empty()) return {Level::kNotice, name + ", not on this machine"};
  constexpr std::size_t kDigits = 8;
  return {Level::kGood,
          fmt::format("{} {}, {}", name, sha256.substr(0, kDigits), age_text(age).toStdString())};
}

}  // namespace scan_cell_rviz
