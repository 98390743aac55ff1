// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/parameter_reader.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scan_cell_common/errors.h"

namespace scan_cell_common {
namespace {

std::string to_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void check_range(const std::string& name, double value, const ParameterReader::Range& range) {
  if (std::isfinite(value) && value >= range.least && value <= range.most) return;
  throw InvalidParameter(
      name, to_text(value),
      "give a value from " + to_text(range.least) + " to " + to_text(range.most));
}

[[noreturn]] void refuse_type(const std::string& name, const std::string& type) {
  throw InvalidParameter(name, "not of type " + type, "give " + type);
}

}  // namespace

ParameterReader::ParameterReader(const ros::NodeHandle& node) : node_(node) {}

template <class T>
bool ParameterReader::get(const std::string& name, const char* type, T& value) {
  const std::string full = node_.resolveName(name);
  names_.insert(full);
  if (!node_.hasParam(name)) return false;
  if (!node_.getParam(name, value)) refuse_type(full, type);
  return true;
}

void ParameterReader::read(const std::string& name, double& value, const Range& range) {
  if (get(name, "a number", value)) check_range(node_.resolveName(name), value, range);
}

void ParameterReader::read(const std::string& name, int& value, const Range& range) {
  constexpr const char* kType = "a whole number";
  XmlRpc::XmlRpcValue set;  // as an int, roscpp would round a fraction
  if (!get(name, kType, set)) return;
  const std::string full = node_.resolveName(name);
  if (set.getType() != XmlRpc::XmlRpcValue::TypeInt) refuse_type(full, kType);
  check_range(full, static_cast<int&>(set), range);
  value = static_cast<int&>(set);
}

void ParameterReader::read(const std::string& name, bool& value) {
  get(name, "true or false", value);
}

void ParameterReader::read(const std::string& name, std::string& value) {
  get(name, "a text", value);
}

void ParameterReader::read(const std::string& name, std::vector<double>& value,
                           const Range& range) {
  if (!get(name, "a list of numbers", value)) return;
  for (const double element : value)
    check_range(node_.resolveName(name), element, range);
}

void ParameterReader::read_choice(const std::string& name, std::string& value,
                                  const std::vector<std::string>& choices) {
  get(name, "a text", value);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return;
  std::string allowed;
  for (const std::string& choice : choices)
    allowed += (allowed.empty() ? "" : ", ") + choice;
  throw InvalidParameter(node_.resolveName(name), "'" + value + "'", "give one of " + allowed);
}

void ParameterReader::throw_if_missing(const std::string& name) const {
  if (node_.hasParam(name)) return;
  throw InvalidParameter(node_.resolveName(name), "not set", "set it in the launch file");
}

void ParameterReader::refuse_unknown() const {
  std::vector<std::string> all;
  node_.getParamNames(all);
  const std::string prefix = node_.getNamespace() + "/";
  for (const std::string& full : all) {
    if (full.compare(0, prefix.size(), prefix) != 0) continue;
    const bool known = std::any_of(names_.begin(), names_.end(), [&full](const std::string& name) {
      return full == name || full.compare(0, name.size() + 1, name + "/") == 0;
    });
    if (!known) {
      throw InvalidParameter(full, "no such parameter", "check its spelling, or remove it");
    }
  }
}

}  // namespace scan_cell_common
