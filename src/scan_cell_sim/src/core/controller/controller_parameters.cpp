// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "controller/controller_parameters.h"

#include <array>
#include <cmath>

#include "controller/wire/wire_json.h"
#include "scan_cell_common/pose/units.h"

namespace scan_cell_sim {
namespace {

using nlohmann::json;
using Code = ControllerErrorCode;
using scan_cell_common::Nanoseconds;

constexpr double kPercent = 0.01;
using scan_cell_common::kDegree;
using scan_cell_common::kMillimetre;

/// A setting of motions that is a number.
struct NumberSetting {
  const char* name;
  double least, most;  // in its unit on the wire
  double unit;         // in SI
  double& (*of)(MotionSettings&);
};

const std::array<NumberSetting, 4> kNumbers = {
    {{"override", 0.01, 100, kPercent, [](MotionSettings& s) -> double& { return s.override; }},
     {"linear_speed", 0.01, 1500, kMillimetre,
      [](MotionSettings& s) -> double& { return s.line.speed; }},
     {"linear_acceleration", 10, 5000, kMillimetre,
      [](MotionSettings& s) -> double& { return s.line.acceleration; }},
     {"rotational_speed", 1, 180, kDegree,
      [](MotionSettings& s) -> double& { return s.line.rotational_speed; }}}};

/// A setting of motions that is "linear" or another word.
struct WordSetting {
  const char* name;
  const char* other;
  bool& (*is_other)(MotionSettings&);
};

const std::array<WordSetting, 2> kWords = {
    {{"motion_type", "joint", [](MotionSettings& s) -> bool& { return s.in_joints; }},
     {"interpolation", "euler", [](MotionSettings& s) -> bool& { return s.line.euler; }}}};

/// A default without rounding errors, as a person would write it.
double without_rounding(double value) {
  constexpr double kSteps = 1e9;  // in a unit; chosen
  return std::round(value * kSteps) / kSteps;
}

bool is_frame(const std::string& name) {
  return name == "base_frame" || name == "tool_frame" || name == "user_frame";
}

}  // namespace

ControllerParameters::ControllerParameters(MotionControl& motion, double stream_period)
    : motion_(motion), stream_period_(stream_period) {
  MotionSettings settings = motion.settings();
  for (const NumberSetting& number : kNumbers)
    values_[number.name] = without_rounding(number.of(settings) / number.unit);
  for (const WordSetting& word : kWords)
    values_[word.name] = word.is_other(settings) ? word.other : "linear";
  for (const char* const frame : {"base_frame", "tool_frame", "user_frame"})
    values_[frame] = WireSix{};
  values_["stream_period"] = without_rounding(stream_period / kMillimetre);
  values_["model"] = "smart5_six (simulated)";
  values_["joint_lower"] = shown(joint_limits().lower);
  values_["joint_upper"] = shown(joint_limits().upper);
  values_["joint_speed"] = shown(joint_limits().speed);
}

const json& ControllerParameters::get(const std::string& name) const {
  const auto found = values_.find(name);
  if (found != values_.end()) return found->second;
  throw ControllerRefusal(Code::kUnknownParameter, "no parameter " + name);
}

void ControllerParameters::set(const std::string& name, const json& value, Nanoseconds now) {
  get(name);  // throws where there is none
  if (is_frame(name)) {
    pose(value, name);
  } else if (name == "stream_period") {
    stream_period_ = number(value, name, 2, 10) * kMillimetre;
  } else {
    set_motion(name, value, now);
  }
  values_[name] = value;
}

void ControllerParameters::set_motion(const std::string& name, const json& value, Nanoseconds now) {
  MotionSettings settings = motion_.settings();
  bool known = false;
  for (const NumberSetting& setting : kNumbers) {
    if (name != setting.name) continue;
    known = true;
    setting.of(settings) = number(value, name, setting.least, setting.most) * setting.unit;
  }
  for (const WordSetting& setting : kWords) {
    if (name != setting.name) continue;
    known = true;
    const std::string word = text(value, name);
    if (word != "linear" && word != setting.other) {
      throw ControllerRefusal(Code::kOutOfRange, name + " is linear or " + setting.other);
    }
    setting.is_other(settings) = word == setting.other;
  }
  if (!known) throw ControllerRefusal(Code::kReadOnly, name + " is read-only");
  motion_.set(settings, now);
}

}  // namespace scan_cell_sim
