// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/ros/load_parameters.h"

#include <algorithm>

#include "scan_cell_common/errors/errors.h"

namespace scan_cell_common {
namespace {

/// Converts a value of the parameter server to the type of a parameter.
struct TakeParameter {
  const ros::NodeHandle& node;
  const std::string& name;

  template <class T>
  void operator()(T& value) const {
    constexpr const char* kType = std::is_same_v<T, bool>          ? "true or false"
                                  : std::is_same_v<T, double>      ? "a number"
                                  : std::is_same_v<T, std::string> ? "a string"
                                                                   : "a list of numbers";
    if (!node.getParam(name, value)) refuse(kType);
  }

  void operator()(std::int64_t& value) const {
    XmlRpc::XmlRpcValue set;  // as an int, roscpp would round a fraction
    if (!node.getParam(name, set) || set.getType() != XmlRpc::XmlRpcValue::TypeInt)
      refuse("a whole number");
    value = static_cast<int&>(set);
  }

  [[noreturn]] void refuse(const std::string& type) const {
    throw InvalidParameter(node.resolveName(name), "wrong type", "give " + type);
  }
};

}  // namespace

RosParameters::RosParameters(const ros::NodeHandle& node) : node_(node) {}

void RosParameters::visit(const Parameter& parameter, ParameterValue& value) {
  names_.insert(named(parameter.name));
  if (node_.hasParam(parameter.name)) {
    std::visit(TakeParameter{node_, parameter.name}, value);
  } else if (parameter.required) {
    throw InvalidParameter(named(parameter.name), "not set", "set it in the launch file");
  }
}

bool RosParameters::is_given(const std::string& old, const std::string&) {
  return node_.hasParam(old);
}

std::string RosParameters::named(const std::string& name) const {
  return node_.resolveName(name);
}

void RosParameters::refuse_unknown() const {
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
