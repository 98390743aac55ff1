// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>
#include <set>

#include "cloud_preprocess/clean.h"
#include "scan_cell_common/files/yaml_file.h"
#include "scan_cell_common/parameters/parameter_table.h"

namespace cloud_preprocess {
namespace {

using scan_cell_common::Parameter;
using scan_cell_common::ParameterValue;
using scan_cell_common::YamlEntry;

/// Reads one section of a YAML file.
class YamlSection final : public scan_cell_common::ParameterTable {
 public:
  YamlSection(const YamlEntry& root, const std::string& section)
      : entry_(root[section]), section_(section) {}

  void refuse_unknown() const { entry_.refuse_unknown(names_); }

 private:
  void visit(const scan_cell_common::Parameter& parameter, ParameterValue& value) override {
    names_.insert(parameter.name);
    if (!entry_.has(parameter.name)) return;
    std::visit([entry = entry_[parameter.name]](
                   auto& as) { as = entry.template as<std::decay_t<decltype(as)>>(); },
               value);
  }
  bool is_given(const std::string& old, const std::string&) override { return entry_.has(old); }
  std::string named(const std::string& name) const override { return section_ + "." + name; }

  YamlEntry entry_;
  std::string section_;
  std::set<std::string> names_;
};

template <class Parameters>
void read_section(const YamlEntry& root, const std::string& section, Parameters& parameters) {
  if (!root.has(section)) return;
  YamlSection table(root, section);
  describe(table, parameters);
  table.refuse_unknown();
}

/// The values of one section.
class SectionValues final : public scan_cell_common::ParameterTable {
 public:
  template <class Parameters>
  explicit SectionValues(Parameters parameters) {
    describe(*this, parameters);
  }

  const std::map<std::string, ParameterValue>& values() const { return values_; }

 private:
  void visit(const Parameter& parameter, ParameterValue& value) override {
    values_[parameter.name] = value;
  }
  bool is_given(const std::string&, const std::string&) override { return false; }

  std::map<std::string, ParameterValue> values_;
};

/// The shortest number that reads back the same.
YAML::Node node_of_value(double number) {
  return YAML::Node(fmt::format("{}", number));
}

YAML::Node node_of_value(const std::vector<double>& numbers) {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  for (const double number : numbers)
    list.push_back(node_of_value(number));
  return list;
}

template <class Value>
YAML::Node node_of_value(const Value& value) {
  return YAML::Node(value);
}

/// The parameters that differ from their defaults; an empty map if none does.
template <class Parameters>
YAML::Node changed(const Parameters& parameters) {
  const SectionValues defaults{Parameters()}, now{parameters};
  YAML::Node section(YAML::NodeType::Map);
  for (const auto& [name, value] : now.values())
    if (value != defaults.values().at(name))
      section[name] = std::visit([](const auto& as) { return node_of_value(as); }, value);
  if (section.size() == 0) section.SetStyle(YAML::EmitterStyle::Flow);
  return section;
}

}  // namespace

CleanParameters read_clean_parameters(const YamlEntry& root) {
  if (root.is_null()) return {};
  root.refuse_unknown({"edits", "floor", "outliers", "isolate", "grid"});
  CleanParameters parameters;
  if (root.has("edits")) parameters.edits = read_edits(root["edits"]);
  read_section(root, "floor", parameters.floor);
  read_section(root, "outliers", parameters.outliers);
  read_section(root, "isolate", parameters.isolate);
  if (root.has("grid") && !root["grid"].is_map() && !root["grid"].as<bool>()) {
    parameters.grid.reset();
  } else {
    read_section(root, "grid", *parameters.grid);
  }
  return parameters;
}

CleanParameters load_clean_parameters(const std::string& path) {
  return read_clean_parameters(YamlEntry::load(path));
}

std::string stages_yaml(const CleanParameters& parameters) {
  YAML::Node root;
  root["floor"] = changed(parameters.floor);
  root["outliers"] = changed(parameters.outliers);
  root["isolate"] = changed(parameters.isolate);
  YAML::Emitter out;
  out << root;
  return std::string(out.c_str()) + "\n";
}

}  // namespace cloud_preprocess
