// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scan_cell_common/files/yaml_file.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "scan_cell_common/errors/utf8.h"
#include "scan_cell_common/pose/unit_quaternion.h"

namespace scan_cell_common {

YAML::Node load_yaml(const std::string& path) {
  return parse_yaml(read_file(path), path);
}

YAML::Node parse_yaml(const std::string& text, const std::string& name) {
  check_utf8(text, name);
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw FileError(name, error.what(), "correct the YAML");
  }
}

YamlEntry YamlEntry::parse(const std::string& text, const std::string& name) {
  return {parse_yaml(text, name), name};
}

YamlEntry YamlEntry::load(const std::string& path) {
  return {load_yaml(path), path};
}

YamlEntry::YamlEntry(const YAML::Node& node, const std::string& file, const std::string& name)
    : node_(node), file_(file), name_(name) {}

std::string YamlEntry::child(const std::string& key) const {
  return name_.empty() ? key : name_ + "." + key;
}

bool YamlEntry::is_map() const {
  return node_.IsMap();
}

bool YamlEntry::is_list() const {
  return node_.IsSequence();
}

bool YamlEntry::is_null() const {
  return node_.IsNull();
}

bool YamlEntry::has(const std::string& key) const {
  return is_map() && node_[key];
}

YamlEntry YamlEntry::operator[](const std::string& key) const {
  if (!has(key)) YamlEntry(node_, file_, child(key)).refuse("missing", "add it");
  return {node_[key], file_, child(key)};
}

std::vector<double> YamlEntry::numbers(std::size_t count) const {
  const auto values = as<std::vector<double>>();
  if (values.size() != count) {
    refuse(fmt::format("{} numbers", values.size()), fmt::format("give {}", count));
  }
  for (const double value : values) {
    if (!std::isfinite(value)) refuse("not finite", "give numbers");
  }
  return values;
}

Eigen::Vector3d YamlEntry::direction() const {
  constexpr double kShortest = 1e-6;
  constexpr double kUnit = 1e-9;  // deviation from length 1 by rounding
  const Eigen::Vector3d given = vector<3>();
  const double length = given.norm();
  if (!(length > kShortest && std::isfinite(length)))
    refuse("no direction", "give x, y and z of a vector");
  return std::abs(length - 1) < kUnit ? given : Eigen::Vector3d(given / length);
}

Eigen::Isometry3d YamlEntry::pose() const {
  const YamlEntry rotation = (*this)["rotation"];
  const Eigen::Quaterniond xyzw(rotation.vector<4>());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = (*this)["translation"].vector<3>();
  pose.linear() = rotation_from(xyzw, file_ + ": " + rotation.name());
  return pose;
}

std::vector<YamlEntry> YamlEntry::elements() const {
  if (!node_.IsSequence()) refuse("not a list", "give a list");
  std::vector<YamlEntry> result;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    result.emplace_back(node_[i], file_, fmt::format("{}[{}]", name_, i));
  }
  return result;
}

std::vector<std::pair<std::string, YamlEntry>> YamlEntry::entries() const {
  if (!is_map()) refuse("not a map of names to values", "give name: value");
  std::vector<std::pair<std::string, YamlEntry>> result;
  for (const auto& pair : node_) {
    if (!pair.first.IsScalar()) refuse("a name that is a list or a map", "give name: value");
    const auto key = pair.first.as<std::string>();
    result.emplace_back(key, YamlEntry(pair.second, file_, child(key)));
  }
  return result;
}

void YamlEntry::refuse_unknown(const std::set<std::string>& known) const {
  for (const auto& [key, entry] : entries())
    if (known.count(key) == 0) entry.refuse("no such entry", "check its spelling");
}

void YamlEntry::refuse(const std::string& value, const std::string& cure) const {
  const int line = node_.Mark().line;  // counted from 0; -1: it was not read from a text
  throw UnusableInput(name_.empty() ? file_ : file_ + ": " + name_,
                      line < 0 ? value : fmt::format("{} (line {})", value, line + 1), cure);
}

YAML::Node yaml_list(const Eigen::VectorXd& numbers) {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  for (const double number : numbers)
    list.push_back(number);
  return list;
}

YAML::Node yaml_pose(const Eigen::Isometry3d& pose) {
  YAML::Node node;
  node["translation"] = yaml_list(pose.translation());
  node["rotation"] = yaml_list(Eigen::Quaterniond(pose.linear()).coeffs());
  return node;
}

}  // namespace scan_cell_common
