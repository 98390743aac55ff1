// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_sim/controller/controller_parameters.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scan_cell_sim/controller/wire_json.h"

namespace scan_cell_sim {
namespace {

using nlohmann::json;
using Code = ControllerErrorCode;
using scan_cell_common::Nanoseconds;

constexpr double kPercent = 0.01;
constexpr double kMillimetre = 1e-3;
constexpr double kDegree = M_PI / 180;

}  // namespace

ControllerParameters::ControllerParameters(MotionControl& motion, double stream_period)
    : motion_(motion), stream_period_(stream_period) {}

json ControllerParameters::get(const std::string& name) const {
  const MotionSettings settings = motion_.settings();
  if (name == "motion_type") return settings.in_joints ? "joint" : "linear";
  if (name == "interpolation") return settings.line.euler ? "euler" : "linear";
  if (name == "override") return settings.override / kPercent;
  if (name == "linear_speed") return settings.line.speed / kMillimetre;
  if (name == "linear_acceleration") return settings.line.acceleration / kMillimetre;
  if (name == "rotational_speed") return settings.line.rotational_speed / kDegree;
  if (name == "stream_period") return stream_period_ * 1000;
  if (name == "base_frame") return base_frame_;
  if (name == "tool_frame") return tool_frame_;
  if (name == "user_frame") return user_frame_;
  if (name == "model") return "smart5_six (simulated)";
  if (name == "joint_lower") return to_wire(joint_limits().lower);
  if (name == "joint_upper") return to_wire(joint_limits().upper);
  if (name == "joint_speed") return to_wire(joint_limits().speed);
  throw ControllerRefusal(Code::UnknownParameter, "no parameter " + name);
}

void ControllerParameters::set(const std::string& name, const json& value, Nanoseconds now) {
  MotionSettings settings = motion_.settings();
  if (name == "motion_type" || name == "interpolation") {
    const std::string word = text(value, name);
    const std::string other = name == "motion_type" ? "joint" : "euler";
    if (word != "linear" && word != other) {
      throw ControllerRefusal(Code::OutOfRange, name + " is linear or " + other);
    }
    (name == "motion_type" ? settings.in_joints : settings.line.euler) = word == other;
    motion_.set(settings, now);
  } else if (name == "base_frame") {
    base_frame_ = six(value, name);
  } else if (name == "tool_frame") {
    tool_frame_ = six(value, name);
  } else if (name == "user_frame") {
    user_frame_ = six(value, name);
  } else if (name == "override") {
    settings.override = number(value, name, 0.01, 100) * kPercent;
    motion_.set(settings, now);
  } else if (name == "linear_speed") {
    settings.line.speed = number(value, name, 0.01, 1500) * kMillimetre;
    motion_.set(settings, now);
  } else if (name == "linear_acceleration") {
    settings.line.acceleration = number(value, name, 10, 5000) * kMillimetre;
    motion_.set(settings, now);
  } else if (name == "rotational_speed") {
    settings.line.rotational_speed = number(value, name, 1, 180) * kDegree;
    motion_.set(settings, now);
  } else if (name == "stream_period") {
    stream_period_ = number(value, name, 2, 10) / 1000;
  } else {
    get(name);  // throws where there is none
    throw ControllerRefusal(Code::ReadOnly, name + " is read-only");
  }
}

}  // namespace scan_cell_sim
