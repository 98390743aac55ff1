// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "wire/parameter_values.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "scan_cell_common/errors/errors.h"

namespace c4g_driver {
namespace {

using nlohmann::json;

std::optional<double> number_of(const SetParameter& set, const std::string& name) {
  if (set.name != name) return std::nullopt;
  const json value = json::parse(set.value, nullptr, false);
  if (!value.is_number()) {
    throw scan_cell_common::Refused("value of " + set.name, "'" + set.value + "'", "give a number");
  }
  return value.get<double>();
}

[[noreturn]] void refuse(const std::string& name, const std::string& value,
                         const std::string& wanted) {
  throw scan_cell_common::ProtocolError("parameter " + name + " of the controller",
                                        value.empty() ? "no value" : value,
                                        "set " + wanted + "; see c4g_protocol.md");
}

/// A parameter that is one of two words. The meaning of a third one would be unknown, so nothing
/// could be checked before a motion.
/// @return whether it is `other`
bool is_other(const std::string& name, const std::string& text, const std::string& usual,
              const std::string& other) {
  const json value = json::parse(text, nullptr, false);
  if (!value.is_string() || (value != usual && value != other)) {
    refuse(name, text, json(usual).dump() + " or " + json(other).dump());
  }
  return value == other;
}

}  // namespace

std::optional<double> override_of(const SetParameter& set) {
  return number_of(set, "override");
}

std::optional<double> linear_speed_of(const SetParameter& set) {
  const auto speed = number_of(set, "linear_speed");
  if (!speed) return std::nullopt;
  constexpr double kMillimetresAMetre = 1e3;  // as a divisor: 700 mm/s is 0.7 m/s to the last digit
  return *speed / kMillimetresAMetre;
}

bool goes_in_joints(const std::string& text) {
  return is_other("motion_type", text, "linear", "joint");
}

bool turns_by_euler_angles(const std::string& text) {
  return is_other("interpolation", text, "linear", "euler");
}

double rotational_speed_of(const std::string& text) {
  const json value = json::parse(text, nullptr, false);
  const double speed = value.is_number() ? value.get<double>() : 0;
  if (!(speed > 0)) refuse("rotational_speed", text, "degrees a second above 0");
  return speed * M_PI / 180;
}

}  // namespace c4g_driver
